"""What must hold of the table."""


# The loops of known length that each image has counted.
ROUNDS = [0, 1_000, 100_000]


def broken(table, ceilings, targets):
    """A line for whatever does not hold."""
    return [*miscounted(table, targets), *different_bits(table), *linked(table), *above(table, ceilings, targets)]


def miscounted(table, targets):
    """A loop of n rounds takes what the board says of a round, and no part more."""
    for target in targets:
        for image in target.running:
            of_image = [c for c in table.calibrations if c[:2] == (target.name, image)]
            if [rounds for _, _, rounds, _, _ in of_image] != ROUNDS:
                yield f"{target.name} {image}: has not calibrated its counter"
                continue
            for _, _, rounds, counted, each in of_image:
                if abs(counted - of_image[0][3] - rounds * each) > target.doubt:
                    yield f"{target.name} {image}: the counter is off: {rounds} rounds of {each} counted {counted}"


def different_bits(table):
    """All targets make the bits of the first that has the row; the host's test is handed the table."""
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
