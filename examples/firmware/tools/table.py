"""The rows of results.tsv."""
import difflib
import re

import build
import elf
from targets import MORE, TURNING, VERBS

COLUMNS = ("target scene scalar method hash insn_per_body_step cycles_per_body_step insn_worst_step flash_bytes "
           "ram_bytes stack_bytes panic_symbols f64_symbols").split()
# What an image prints of a row.
PRINTED = COLUMNS[1:8] + COLUMNS[9:11]

HASHES = re.compile(r"[0-9a-f]+|\d+:[0-9a-f]+( \d+:[0-9a-f]+)*")


def image_key(target, image):
    return f"{target.name} at {image.parent.parent.name}, {image.name}"


class Table:
    def __init__(self, rows=()):
        self.rows = list(rows)
        # (target, image, rounds, counted, expected of a round)
        self.calibrations = []
        # Symbols of a heap, of atomics, or of rung two where nothing turns, by image.
        self.forbidden = {}
        # Pictures, by where they are committed.
        self.pictures = {}
        # Bytes of the firmware to copy.
        self.template = None

    @staticmethod
    def joined(tables):
        all_rows = Table()
        for table in tables:
            all_rows.rows += table.rows
            all_rows.calibrations += table.calibrations
            all_rows.forbidden |= table.forbidden
            all_rows.pictures |= table.pictures
            all_rows.template = all_rows.template or table.template
        return all_rows

    @staticmethod
    def read(path):
        lines = path.read_text().splitlines()
        return Table(dict(zip(COLUMNS, line.split("\t"))) for line in lines[1:])

    def text(self):
        lines = [COLUMNS, *([row[column] for column in COLUMNS] for row in self.rows)]
        return "".join("\t".join(line) + "\n" for line in lines)

    def add_output(self, target, output, image):
        """Rows that an image has printed; `cortex-m0` stands for its triple."""
        symbols = self.symbols(target, image)
        for line in output.splitlines():
            first, *fields = line.split("\t")
            if line == "EXIT 0":  # of the console
                continue
            if first == "calibration":
                self.calibrations.append((target.name, image.name, *map(int, fields)))
                continue
            if len(fields) + 1 != len(PRINTED) or not HASHES.fullmatch(fields[2]):
                raise build.Failed(f"{target.name} {image.name} prints: {line}")
            row = dict.fromkeys(COLUMNS, "-") | dict(zip(PRINTED, [first, *fields])) | symbols
            self.rows.append(row | {"target": target.triple})

    def add_picture(self, target, folder, image):
        """Pictures that an image has drawn."""
        self.clean(target, image)
        self.pictures |= {f"{target.name}/{picture.name}": picture.read_bytes() for picture in folder.glob("*.png")}

    def add_weight(self, target, level, image, empty):
        """A row of flash: what the image takes more than start-up and exit. The gravity scene, as the
        images are priced, has its row already."""
        name = image.name.removeprefix("with_")
        self.clean(target, image)
        if name in ("empty", *VERBS):
            return
        flash = str(elf.flash(image) - elf.flash(empty))
        if level == "3":
            priced = ("gravity 1/64", "I16F16", "SemiImplicitEuler")
            row = next(row for row in self.rows if (row["scene"], row["scalar"], row["method"]) == priced)
            row["flash_bytes"] = flash
            return
        scene = f"flash gravity 1/64 at {level}" + (f" + {MORE[name]}" if name in MORE else "")
        row = dict.fromkeys(COLUMNS, "-") | {"target": target.triple, "scene": scene, "flash_bytes": flash}
        self.rows.append(row | self.symbols(target, image))

    def add_template(self, target, image):
        self.clean(target, image)
        self.template = elf.flash(image)

    def clean(self, target, image):
        """An image without a row must have no symbol that a row would tell of."""
        symbols = self.symbols(target, image)
        complaints = [name for name, found in symbols.items() if found not in ("0", "-")]
        self.forbidden[image_key(target, image)] += complaints

    def symbols(self, target, image):
        found = elf.symbols(image)
        if found is None:
            self.forbidden[image_key(target, image)] = []
            return {"panic_symbols": "0", "f64_symbols": "-"}
        turning = [] if image.name in TURNING else found.turning
        if image.name == "rigid" and not found.turning:
            turning = ["nothing that turns, by the pattern"]
        self.forbidden[image_key(target, image)] = [*found.forbidden, *turning]
        return {"panic_symbols": str(len(found.panics)), "f64_symbols": str(len(found.doubles))}

    def differs_from(self, path, targets):
        triples = {target.triple for target in targets}
        committed = Table(row for row in Table.read(path).rows if row["target"] in triples)
        lines = difflib.unified_diff(committed.text().splitlines(), self.text().splitlines(),
                                     path.name, "measured", lineterm="", n=0)
        return list(lines)
