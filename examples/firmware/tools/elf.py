"""Sizes and symbols of images, by `readelf`, which reads any machine's."""
import re
import subprocess
from dataclasses import dataclass

# No core here computes with f64: whatever makes or reads one calls one of these.
DOUBLES = re.compile(r"__(aeabi_(d|cd|[a-z]+2d)|[a-z]+df)")
PANICS = re.compile(r"panic|unwrap_failed|expect_failed|slice_index|a_panic_is_possible")
# Modules of bodies that turn, as names of the compiler have them: none of a scene of points.
TURNING = re.compile(r"5rigid|6torque|4mass(4disc|4ring|7capsule|7outline|7polygon|9rectangle|10properties)|7angular|6circle")
FORBIDDEN = re.compile(r"__rust_alloc|__rust_realloc|__rdl_|__rg_|^malloc$|^calloc$|__atomic_|__sync_")


@dataclass
class Symbols:
    panics: list[str]
    doubles: list[str]
    forbidden: list[str]
    turning: list[str]


def readelf(*arguments):
    return subprocess.run(["readelf", "--wide", *map(str, arguments)], capture_output=True, text=True, check=True).stdout


def is_elf(image):
    return image.open("rb").read(4) == b"\x7fELF"


def flash(image):
    """Bytes of what is allocated and not zero at start."""
    fields = (line.split("]", 1)[1].split() for line in readelf("-S", image).splitlines() if re.match(r"\s+\[\s*\d+\]", line))
    return sum(int(section[4], 16) for section in fields
               if len(section) > 7 and section[1] in ("PROGBITS", "ARM_EXIDX") and "A" in section[6])


def symbols(image):
    """None for what is no ELF image: there an undefined function is an import, and does not run."""
    if not is_elf(image):
        return None
    names = [fields[7] for line in readelf("-s", image).splitlines() if len(fields := line.split()) == 8]
    if "main" not in names:
        raise RuntimeError(f"{image} has no names")
    def found(pattern):
        return [name for name in names if pattern.search(name)]

    return Symbols(found(PANICS), [name for name in names if DOUBLES.match(name)], found(FORBIDDEN),
                   found(TURNING))
