//! What is worth its price: the points that no other point beats.

/// A price and an error; what failed has an error that is infinite.
pub type Point = (f64, f64);

/// Whether `a` is as cheap as `b` and as good, and better in one of the two.
pub fn beats(a: &Point, b: &Point) -> bool {
    a.0 <= b.0 && a.1 <= b.1 && a != b
}

/// Whether each point is on the front: no other beats it. An error that is not finite is never on it.
pub fn front(points: &[Point]) -> Vec<bool> {
    let on = |point: &Point| point.1.is_finite() && !points.iter().any(|other| beats(other, point));
    points.iter().map(on).collect()
}

/// The corners of a staircase through points on the front, from the top edge to the right one.
pub fn stairs(points: &[Point], top: f64, right: f64) -> Vec<Point> {
    let mut steps: Vec<Point> = points.to_vec();
    steps.sort_by(|a, b| a.0.total_cmp(&b.0));
    let (mut corners, mut height) = (Vec::new(), top);
    for (x, y) in steps {
        corners.extend([(x, height), (x, y)]);
        height = y;
    }
    corners.push((right, height));
    corners
}
