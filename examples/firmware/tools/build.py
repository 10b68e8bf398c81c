"""Compiles images and runs them: with rustup's target where it is installed, else with Debian's Rust,
which brings the source of `core`."""
import os
import shutil
import subprocess
import threading
from pathlib import Path

HERE = Path(__file__).resolve().parent.parent
PINNED = ["rustc-web", "cargo-web", "rust-web-src", "lld-22"]
PINNED_RUST = "1.96."
# That of the images, for what is not in their workspace: so `core` is compiled once.
PROFILE = {f"CARGO_PROFILE_RELEASE_{key}": value for key, value in
           {"LTO": "true", "CODEGEN_UNITS": "1", "PANIC": "abort", "DEBUG": "false"}.items()}
cargo_at_work = threading.Lock()


class Missing(Exception):
    """Something is to be installed first."""


class Failed(Exception):
    """An image did not build, or did not run to its end."""


def need(targets, pinned):
    """Installs what is missing, as root in CI; else says what to install."""
    packages = {package for target in targets for package in target.packages}
    if any(pinned or not rustup_has(target.triple) for target in targets):
        packages.update(PINNED)
    if not (packages := lacking(packages)):
        return
    if os.environ.get("CI") and os.geteuid() == 0:
        quiet = dict(check=True, stdout=subprocess.DEVNULL)
        subprocess.run(["apt-get", "update", "-qq"], **quiet)
        subprocess.run(["apt-get", "install", "-y", "-qq", "--no-install-recommends", *packages], **quiet)
        return
    triples = " ".join(target.triple for target in targets if target.name != "gba")  # rustup has none for it
    raise Missing(f"missing: apt-get install --no-install-recommends {' '.join(packages)}\n"
                  f"(of these {' '.join(PINNED)} only for gba, and without: rustup target add {triples})")


def lacking(packages):
    """Of Debian's packages those that are not there, by what they are for."""
    commands = {"qemu-system-arm": "qemu-system-arm", "qemu-system-misc": "qemu-system-riscv32", "nodejs": "node",
                "lld-22": "ld.lld-22", "gcc": "cc", "binutils": "readelf"}
    return sorted(package for package in packages
                  if not (shutil.which(commands[package]) if package in commands else installed(package)))


def installed(package):
    query = ["dpkg-query", "-W", "-f", "${Status}", package]
    try:
        return "install ok installed" in subprocess.run(query, capture_output=True, text=True).stdout
    except FileNotFoundError:
        return False


def rustup_has(triple):
    if not shutil.which("rustc"):
        return False
    sysroot = subprocess.run(["rustc", "--print", "sysroot"], capture_output=True, text=True).stdout.strip()
    return (Path(sysroot) / "lib/rustlib" / triple / "lib").is_dir()


def debian(package, command):
    """Where Debian puts its Rust: not first on the path of a rustup user."""
    files = subprocess.run(["dpkg", "-L", package], capture_output=True, text=True, check=True).stdout.split()
    return next(file for file in files if file.endswith(f"/bin/{command}"))


def cargo(triple, linker, level, out, pinned, arguments):
    """One folder for all targets and levels, so that what runs on the host is compiled once."""
    environment = os.environ | {"CARGO_PROFILE_RELEASE_OPT_LEVEL": level, "CARGO_TARGET_DIR": str(out / "all")} | PROFILE
    for flags in ("RUSTFLAGS", "CARGO_ENCODED_RUSTFLAGS", "CARGO_BUILD_RUSTFLAGS"):
        environment.pop(flags, None)  # they would take the place of a board's own
    command = ["cargo"]
    arguments = [*arguments, "--quiet", "--release", "--target", triple]
    if pinned or not rustup_has(triple):
        rustc = debian("rustc-web", "rustc")
        version = subprocess.run([rustc, "--version"], capture_output=True, text=True).stdout
        if pinned and not version.startswith(f"rustc {PINNED_RUST}"):
            raise Failed(f"figures are of rustc {PINNED_RUST}x, here is {version}")
        environment.pop("RUSTUP_TOOLCHAIN", None)
        linker_key = f"CARGO_TARGET_{triple.upper().replace('-', '_')}_LINKER"
        environment |= {"PATH": f"{Path(rustc).parent}:{environment['PATH']}", "RUSTC": rustc, "RUSTC_BOOTSTRAP": "1",
                        linker_key: linker}
        command = [debian("cargo-web", "cargo")]
        arguments.append("-Zbuild-std=core")
    with cargo_at_work:
        done = subprocess.run([*command, *arguments], cwd=HERE, env=environment, capture_output=True, text=True)
    if done.returncode:
        raise Failed(f"{' '.join(arguments)}\n{done.stderr}")


def images(target, level, names, out, pinned):
    """The folder with the images, which carry no suffix."""
    bins = [part for name in dict.fromkeys(names) for part in ("--bin", name)]
    # Cargo runs beside the packages, and would not see what one of them asks for.
    package = ["build", "--package", f"fixstep-{target.name}", "--config", f"{target.name}/.cargo/config.toml"]
    cargo(target.triple, target.linker, level, out, pinned, [*package, *bins])
    folder = out / level / target.name
    folder.mkdir(parents=True, exist_ok=True)
    for name in names:
        shutil.copy(out / "all" / target.triple / "release" / f"{name}{target.suffix}", folder / name)
    return folder


def runner(target, out):
    """The emulator's command; one that comes as source is compiled first."""
    if not target.runner:
        return target.emulator
    made = out / Path(target.runner).stem
    libraries = [f"-l{name}" for name in target.libraries]
    done = subprocess.run(["cc", "-O2", "-o", made, HERE / target.runner, *libraries], capture_output=True, text=True)
    if done.returncode:
        raise Failed(f"{target.runner}: {done.stderr}")
    return [str(made), *target.emulator]


def run(target, emulator, image):
    """What an image prints."""
    try:
        done = subprocess.run([*emulator, image], cwd=HERE, stdin=subprocess.DEVNULL, capture_output=True,
                              text=True, timeout=900)
    except subprocess.TimeoutExpired:
        raise Failed(f"{target.name} {image.name}: does not end")
    if done.returncode:
        raise Failed(f"{target.name} {image.name}: exit code {done.returncode}\n{done.stdout[-500:]}{done.stderr}")
    return done.stdout


def draw(emulator, image, options):
    """The folder with the pictures of an image."""
    folder = image.parent / "pictures"
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir()
    done = subprocess.run([*emulator, *(option.format(folder) for option in options), image], cwd=HERE,
                          stdin=subprocess.DEVNULL, capture_output=True, text=True, timeout=900)
    if done.returncode:
        raise Failed(f"{image.name}: {done.stdout[-500:]}{done.stderr}")
    return folder


def template(out, pinned):
    """The image of the firmware to copy, of which 60 lines are enough."""
    lines = len((HERE / "template/src/main.rs").read_text().splitlines())
    if lines > 60:
        raise Failed(f"template/src/main.rs has {lines} lines")
    arguments = ["build", "--manifest-path", "template/Cargo.toml"]
    cargo("thumbv6m-none-eabi", "ld.lld-22", "3", out, pinned, arguments)
    return out / "all/thumbv6m-none-eabi/release/my-firmware"


def host_agrees(table, out):
    """Complaints of the host's test about the hashes of a table."""
    path = out / "measured.tsv"
    path.write_text(table.text())
    environment = {key: value for key, value in os.environ.items() if key != "CARGO_TARGET_DIR"}
    environment["FIRMWARE_RESULTS"] = str(path.resolve())
    test = ["cargo", "test", "--quiet", "--test", "suite", "the_host_makes_the_bits"]
    done = subprocess.run(test, cwd=HERE.parent.parent, env=environment, capture_output=True, text=True)
    return [] if done.returncode == 0 else [done.stdout, done.stderr]


def check_features(out, pinned):
    """With every feature of its own the library still needs neither std nor a heap."""
    arguments = ["check", "--manifest-path", "../../Cargo.toml", "--lib", "--features", "serde defmt mint"]
    cargo("thumbv6m-none-eabi", "ld.lld-22", "3", out, pinned, arguments)
