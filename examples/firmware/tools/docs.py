"""Writes the figures into the tables of the README, of docs/costs.md and of the documentation. The pages decide
which rows a table has; only the cells are filled here. `tests/firmware.rs` checks the README, the costs, the guide
and the architecture against results.tsv; `run --pinned` checks all of them."""
import math
import re
from pathlib import Path

from targets import TARGETS

ROOT = Path(__file__).resolve().parents[3]
M0, M4F, RISCV, GBA = (TARGETS[name].triple for name in ("cortex-m0", "cortex-m4f", "riscv", "gba"))
SCALARS = ["I16F16", "f32", "I16F16 carried"]
FIRMWARE = "examples/firmware"
SCENE = "gravity 1/64", "I16F16", "SemiImplicitEuler"


def write(table):
    """Writes them, and the pictures."""
    for path, content in pages(table).items():
        path.write_bytes(content)


def stale(table):
    """A line for each page or picture that is not what was measured."""
    return [f"{path.relative_to(ROOT)} is not what was measured"
            for path, content in pages(table).items() if path.read_bytes() != content]


def pages(table):
    """What the pages and pictures should be."""
    figures = Figures(table)
    bodies = "| body | bytes | M0+ 1/60 |"
    filled = {
        "README.md": fill("README.md", [("| number type | step, s | method | M0+ |", figures.steps)], figures.scene()),
        "docs/costs.md": fill("docs/costs.md", [
            ("| body | step | method | M0+ |", figures.steps),
            ("| | for each | M0+ I16F16 |", figures.forces),
            ("| body that turns | step | method |", figures.turning),
            ("| of a body that turns | for each |", lambda cells: figures.forces(cells, " rigid")),
            ("| the scene, and | M0+ | M4F |", figures.flash),
            ("| method | order | force calls |", figures.methods),
        ], figures.scene() + figures.fast_ram()),
        "src/integrate/mod.rs": fill("src/integrate/mod.rs", [("//! | method | order | force calls |", figures.methods)]),
        "ARCHITECTURE.md": fill("ARCHITECTURE.md", [(bodies, lambda cells: figures.bodies(cells, rounded))]),
        "src/guide/mod.rs": fill("src/guide/mod.rs", [("//! " + bodies, lambda cells: figures.bodies(cells, str))]),
        f"{FIRMWARE}/gba/README.md": fill(f"{FIRMWARE}/gba/README.md", [("| step | Thumb in", figures.console)]),
    }
    sentence = [(r"image takes (\d+) bytes", str(table.template))]
    filled[f"{FIRMWARE}/template/README.md"] = fill(f"{FIRMWARE}/template/README.md", [], sentence)
    texts = {ROOT / path: text.encode() for path, text in filled.items()}
    return texts | {ROOT / FIRMWARE / path: content for path, content in table.pictures.items()}


def fill(path, tables, sentences=()):
    """Has each row of each table, which begins with a header, filled by a function of its cells."""
    lines = (ROOT / path).read_text().split("\n")
    for header, filled in tables:
        start = next(i for i, line in enumerate(lines) if line.startswith(header)) + 2
        for i in range(start, len(lines)):
            before, bar, row = lines[i].partition("|")
            if not bar:
                break
            cells = [cell.strip() for cell in row.rstrip("|").split("|")]
            lines[i] = f"{before}| {' | '.join(filled(cells))} |".replace("|  |", "| |").replace("|  |", "| |")
    text = "\n".join(lines)
    for pattern, figure in sentences:
        text, found = re.subn(pattern, lambda match: match[0].replace(match[1], figure, 1), text)
        assert found == 1, pattern
    return text


def rounded(figure):
    return str(math.floor(float(figure) + 0.5)) if figure else ""


class Figures:
    def __init__(self, table):
        self.rows = {(row["target"], row["scene"], row["scalar"], row["method"]): row for row in table.rows}

    def each(self, *key):
        """Instructions or cycles of a row, nothing where there is none."""
        row = self.rows.get(key)
        return (row["cycles_per_body_step" if key[0] == GBA else "insn_per_body_step"]) if row else ""

    def steps(self, cells):
        body, step, method = cells[:3]
        return [body, step, method, *(self.each(core, f"gravity {step}", body, method) for core in (M0, M4F, RISCV, GBA))]

    def turning(self, cells):
        """As `steps`, with columns between that are counted by hand."""
        body, step, method = cells[:3]
        m0, m4f, riscv, gba = self.steps([f"{body} rigid", step, method])[3:]
        return [body, step, method, m0, cells[4], m4f, cells[6], riscv, gba]

    def forces(self, cells, bodies=""):
        name = cells[0].replace("`", "")
        scene = f"{'beside' if '::' in name else 'force'} {name}"
        columns = [*((core, scalar) for core in (M0, M4F) for scalar in SCALARS), (RISCV, "I16F16"), (GBA, "I16F16")]
        return [*cells[:2], *(rounded(self.each(core, scene, scalar + bodies, "SemiImplicitEuler")) for core, scalar in columns)]

    def flash(self, cells):
        scene = "flash gravity 1/64 at s"

        def bytes_more(core):
            alone = int(self.rows[core, scene, "-", "-"]["flash_bytes"])
            if cells[0] == "nothing more":
                return str(alone)
            more = cells[0].replace("`", "")
            return f"{int(self.rows[core, f'{scene} + {more}', '-', '-']['flash_bytes']) - alone:+}"

        return [cells[0], bytes_more(M0), bytes_more(M4F), self.ram(cells[0].strip("`"))]

    def ram(self, name):
        """Bytes that a scene grows by, of force, method or number type; nothing for what is no part of it."""
        def of(*key):
            return int(self.rows[M0, *key]["ram_bytes"])

        if name == "nothing more":
            return str(of(*SCENE))
        scene, body, method = "gravity 1/60", "I16F16", "SemiImplicitEuler"
        if (M0, f"force {name}", body, method) in self.rows:
            each = {"Anchor": 8, "ExactSpring": 8, "ExactPair": 4}.get(name, 1)
            return f"{(of(f'force {name}', body, method) - of('force no force', body, method)) // each:+}"
        other = {"Carried": "I16F16 carried", "Rigid": "I16F16 rigid"}.get(name, name)
        for key in ((scene, body, name), (scene, other, method)):
            if (M0, *key) in self.rows:
                return f"{of(*key) - of(scene, body, method):+}"
        return ""

    def methods(self, cells):
        name = cells[0].strip("[]`")
        costs = [rounded(self.each(core, "gravity 1/60", "I16F16", name)) for core in (M0, M4F)]
        return [*cells[:8], *costs, *cells[10:]]

    def bodies(self, cells, written):
        kind, scalar = re.fullmatch(r"`(\w+)<(\w+)>`", cells[0]).groups()
        body = f"{scalar} carried" if kind == "Carried" else scalar
        columns = [(core, step) for core in (M0, M4F) for step in ("1/60", "1/64")]
        return [*cells[:2], *(written(self.each(core, f"gravity {step}", body, "SemiImplicitEuler"))
                              for core, step in columns)]

    def console(self, cells):
        """Of the console, in the cartridge and in its fast RAM."""
        scene, scalar = {
            "`DyadicStep`, 4389/2^18 s, one frame": ("gravity 4389/2^18", "I16F16"),
            "the same by `Long`": ("gravity 4389/2^18 by Long", "I16F16"),
            "`DyadicStep`, 1/64 s": ("gravity 1/64", "I16F16"),
            "`Step::hz(60)`": ("gravity 1/60", "I16F16"),
            "`f32`, `Step::hz(60)`": ("gravity 1/60", "f32"),
        }[cells[0]]
        return [cells[0], *(self.each(GBA, of, scalar, "SemiImplicitEuler") for of in (scene, f"{scene} in IWRAM"))]

    def scene(self):
        """Of the sentence that says what the scene takes."""
        row = self.rows[M0, *SCENE]
        return [(r"takes\s+(\d+)\s+bytes of\s+flash", row["flash_bytes"]), (r"(\d+)\s+bytes\s+of\s+RAM", row["ram_bytes"]),
                (r"(\d+)\s+bytes\s+of\s+stack", row["stack_bytes"])]

    def fast_ram(self):
        """Of the sentence about the console's fast RAM."""
        fast = [self.each(GBA, f"gravity {step} in IWRAM", *SCENE[1:]) for step in ("4389/2^18", "1/64")]
        return [(r"takes\s+([\d.]+)\s+cycles at one frame a step", fast[0]), (r"and\s+([\d.]+)\s+at\s+1/64\s+s:", fast[1])]
