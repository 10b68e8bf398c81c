"""Writes the figures into the tables of the README and the documentation. Which rows a table has is
said there; here only the cells are filled. `tests/firmware.rs` holds the same tables against results.tsv."""
import math
import re
from pathlib import Path

from targets import TARGETS

ROOT = Path(__file__).resolve().parents[3]
M0, M4F, RISCV, GBA = (TARGETS[name].triple for name in ("cortex-m0", "cortex-m4f", "riscv", "gba"))
SCALARS = ["I16F16", "f32", "I16F16 carried"]
SCENE = "gravity 1/64", "I16F16", "SemiImplicitEuler"


def write(table):
    figures = Figures(table)
    fill(ROOT / "README.md", [
        ("| body | step | method | M0+ |", figures.steps),
        ("| | for each | M0+ I16F16 |", figures.forces),
        ("| the scene, and | M0+ | M4F |", figures.flash),
        ("| method | order | force calls |", figures.methods),
    ], figures.sentences())
    fill(ROOT / "src/integrate/mod.rs", [("//! | method | order | force calls |", figures.methods)])
    bodies = "| body | bytes | M0+ 1/60 |"
    fill(ROOT / "ARCHITECTURE.md", [(bodies, lambda cells: figures.bodies(cells, rounded))])
    fill(ROOT / "src/guide.rs", [("//! " + bodies, lambda cells: figures.bodies(cells, str))])


def fill(path, tables, sentences=()):
    """Has each row of each table, which begins with a header, filled by a function of its cells."""
    lines = path.read_text().split("\n")
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
    path.write_text(text)


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

    def forces(self, cells):
        name = cells[0].strip("`")
        scene = f"{'beside' if '::' in name else 'force'} {name}"
        columns = [*((core, scalar) for core in (M0, M4F) for scalar in SCALARS), (RISCV, "I16F16"), (GBA, "I16F16")]
        return [*cells[:2], *(rounded(self.each(core, scene, scalar, "SemiImplicitEuler")) for core, scalar in columns)]

    def flash(self, cells):
        scene = "flash gravity 1/64 at s"

        def bytes_more(core):
            alone = int(self.rows[core, scene, "-", "-"]["flash_bytes"])
            if cells[0] == "nothing more":
                return str(alone)
            return f"{int(self.rows[core, f'{scene} + {cells[0].replace('`', '')}', '-', '-']['flash_bytes']) - alone:+}"

        return [cells[0], bytes_more(M0), bytes_more(M4F)]

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

    def sentences(self):
        row = self.rows[M0, *SCENE]
        return [(r"takes\s+(\d+)\s+bytes of\s+flash", row["flash_bytes"]), (r"(\d+)\s+bytes\s+of\s+RAM", row["ram_bytes"]),
                (r"(\d+)\s+bytes\s+of\s+stack", row["stack_bytes"])]
