"""What there is to build and run."""
from dataclasses import dataclass, field

CHARTS = ["chart_cluster", "chart_kepler", "chart_pair", "chart_projectile", "chart_quadratic", "chart_rotor",
          "chart_spring"]
# Images that name every verb.
VERBS = ["everything", "exact", "turning"]
RUNNING = ["price", "forces", "long", "rigid", *VERBS, *CHARTS]
# Images in which something turns; the others hold nothing of rung two.
TURNING = ["rigid", "turning", "chart_rotor", "with_rigid", "with_torque", "with_attached"]
# What `with_NAME` has more than the gravity scene, as the table says it.
MORE = {
    "linear_drag": "LinearDrag",
    "quadratic_drag": "QuadraticDrag",
    "anchor": "Anchor",
    "spring": "Pairs<Spring>",
    "pull": "AllPairs<Pull>",
    "exact_drag": "ExactDrag",
    "exact_quadratic_drag": "ExactQuadraticDrag",
    "exact_spring": "ExactSpring",
    "exact_pair": "ExactPair",
    "verlet": "Verlet",
    "rk4": "Rk4",
    "pefrl": "Pefrl",
    "carried": "Carried",
    "rigid": "Rigid",
    "torque": "Rigid + Torque + SpinDrag",
    "attached": "Rigid + Pairs<Attached>",
    "i8f24": "I8F24",
    "f32": "f32",
    "accumulator": "Accumulator",
    "snapshot": "snapshot",
    "game": "LinearDrag + Pairs<Spring> + Accumulator",
}
WEIGHED = ["empty", "gravity", *(f"with_{more}" for more in MORE)]


@dataclass(frozen=True)
class Target:
    name: str
    triple: str
    # The emulator, to be followed by the image; only its options if it is to be compiled from `runner`.
    emulator: list[str]
    # Debian's packages beside those that every target needs.
    packages: list[str]
    linker: str = "ld.lld-22"
    # Counts that a reading may be off: a tick of a timer is not one instruction.
    doubt: int = 0
    suffix: str = ""
    runner: str = ""
    libraries: list[str] = field(default_factory=list)
    running: list[str] = field(default_factory=lambda: list(RUNNING))
    # Images that draw, and how the emulator is told to keep what they draw, in a folder.
    pictures: dict[str, list[str]] = field(default_factory=dict)
    # Images whose flash is told, by opt-level.
    weighed: dict[str, list[str]] = field(default_factory=lambda: {"3": ["empty", "gravity"]})


# At shift 6 an instruction takes 64 ns of the board's time, whatever the host does.
ARM = ["qemu-system-arm", "-nographic", "-monitor", "none", "-icount", "shift=6",
       "-semihosting-config", "enable=on,target=native"]
RISCV = ["qemu-system-riscv32", "-M", "virt", "-bios", "none", "-nographic", "-monitor", "none", "-icount", "shift=0"]

TARGETS = {target.name: target for target in [
    Target("cortex-m0", "thumbv6m-none-eabi", [*ARM, "-M", "microbit", "-kernel"], ["qemu-system-arm"],
           doubt=1, weighed={"3": ["empty", "gravity"], "s": [*VERBS, *WEIGHED]}),
    Target("cortex-m4f", "thumbv7em-none-eabihf", [*ARM, "-M", "mps2-an386", "-kernel"], ["qemu-system-arm"],
           doubt=1, weighed={"3": ["empty", "gravity"], "s": WEIGHED}),
    Target("riscv", "riscv32imac-unknown-none-elf", [*RISCV, "-kernel"], ["qemu-system-misc"]),
    Target("gba", "thumbv4t-none-eabi", ["-f", "900000"], ["libmgba-dev", "libpng-dev", "gcc"],
           runner="gba/runner/gba-run.c", libraries=["mgba", "png"],
           running=[*RUNNING, "fast"],
           pictures={"showcase": ["-k", "gba/showcase.keys", "-z", "3", "-s", "1200:{}/showcase.png",
                                  "-s", "2200:{}/showcase-buttons.png"]}),
    Target("wasm", "wasm32-unknown-unknown", ["node", "wasm/run.mjs"], ["nodejs"],
           linker="wasm-ld-22", suffix=".wasm", weighed={}),
]}
