"""What must hold of the table."""


def broken(table, ceilings, targets):
    """A line for whatever does not hold."""
    return [*miscounted(table), *different_bits(table), *linked(table), *above(table, ceilings, targets)]


def miscounted(table):
    """A loop of n rounds takes what the board says of a round, and no part more."""
    base = {(target, image): counted for target, image, rounds, counted, _ in table.calibrations if rounds == 0}
    for target, image, rounds, counted, each in table.calibrations:
        # Timers tick once in 62.5 or 40 ns, an instruction takes 64: one tick of doubt at each end.
        if abs(counted - base[target, image] - rounds * each) > 1:
            yield f"{target} {image}: the counter is off: {rounds} rounds of {each} counted {counted}"


def different_bits(table):
    """All targets make the bits of the first that has the row. The host's are compared by its tests."""
    first = {}
    for row in table.rows:
        key = row["scene"], row["scalar"], row["method"]
        known, bits = first.setdefault(key, (row["target"], row["hash"]))
        if row["hash"] != bits:
            yield f"{row['target']} {' '.join(key)}: {row['hash']}, but {known} has {bits}"


def linked(table):
    for row in table.rows:
        for column in ("panic_symbols", "f64_symbols"):
            if row[column] not in ("0", "-"):
                yield f"{row['target']} {row['scene']}: {row[column]} {column.replace('_', ' ')}"
    for image, names in table.forbidden.items():
        if names:
            yield f"{image}: {' '.join(names)}"


def above(table, path, targets):
    """Rows of ceilings.tsv: target, scene, scalar, method, column, most. A figure that is no number, or a
    ceiling without a row, does not hold."""
    triples = {target.triple for target in targets}
    for line in path.read_text().splitlines()[1:]:
        target, scene, scalar, method, column, most = line.split("\t")
        if target not in triples:
            continue
        named = [row for row in table.rows
                 if (row["target"], row["scene"], row["scalar"], row["method"]) == (target, scene, scalar, method)]
        if len(named) != 1:
            yield f"no figure for {line}"
            continue
        try:
            if float(named[0][column]) <= float(most):
                continue
        except ValueError:
            pass
        yield f"{target} {scene} {scalar} {method}: {named[0][column]} {column} is above {most}"
