//! How a line of a chart looks: a colour for its method and forces, a mark and dashes for its body.

use plotters::element::DashedPathElement;
use plotters::prelude::*;

use crate::canvas::{Area, Drawn, line, px};

pub const GREY: RGBColor = RGBColor(208, 208, 208);
pub const DARK: RGBColor = RGBColor(120, 120, 120);
/// Of names beside grey lines.
pub const NAMES: RGBColor = RGBColor(80, 80, 80);

/// In fine pixels.
pub type At = (i32, i32);

#[derive(Clone, Copy)]
pub struct Look {
    pub color: RGBColor,
    mark: char,
    dashed: bool,
}

impl Look {
    pub fn new([method, forces, body]: [&str; 3]) -> Look {
        Look {
            color: color(method, forces),
            mark: match body.trim_end_matches(" carried") {
                "f32" => 'o',
                "I16F16" => '#',
                _ => '^',
            },
            dashed: body.ends_with(" carried"),
        }
    }

    pub fn with_color(self, color: RGBColor) -> Look {
        Look { color, ..self }
    }

    pub fn path(self, area: &Area, points: &[At], width: i32) -> Drawn {
        let (points, style) = (points.iter().copied(), line(self.color, width));
        match self.dashed {
            true => area.draw(&DashedPathElement::new(points, px(6), px(4), style))?,
            false => area.draw(&PathElement::new(points.collect::<Vec<_>>(), style))?,
        }
        Ok(())
    }

    /// A mark; filled, or only its outline.
    pub fn mark(self, area: &Area, (x, y): At, filled: bool) -> Drawn {
        let rings = [(px(5), self.color), (px(5) - px(3) / 2, WHITE)];
        let rings = if filled { &rings[..1] } else { &rings };
        for &(r, color) in rings {
            let style = color.filled();
            match self.mark {
                'o' => area.draw(&Circle::new((x, y), r, style))?,
                '#' => {
                    let half = r * 8 / 9;
                    area.draw(&Rectangle::new(
                        [(x - half, y - half), (x + half, y + half)],
                        style,
                    ))?;
                }
                _ => {
                    let r = r * 5 / 4;
                    let corners = vec![(x, y - r), (x + r, y + r * 3 / 4), (x - r, y + r * 3 / 4)];
                    area.draw(&Polygon::new(corners, style))?;
                }
            }
        }
        Ok(())
    }
}

/// Told apart by most eyes (after Okabe and Ito); drifts that are solved exactly are brown, kicks that
/// are have a darker shade of their method.
fn color(method: &str, forces: &str) -> RGBColor {
    match (method, forces) {
        (_, "Ballistic" | "ExactSpring" | "ExactPair") => RGBColor(125, 62, 10),
        ("Verlet", forces) if is_exact_kick(forces) => RGBColor(90, 60, 160),
        (_, forces) if is_exact_kick(forces) => RGBColor(170, 120, 0),
        ("Euler", _) => RGBColor(204, 121, 167),
        ("ConstantAcceleration", _) => RGBColor(86, 180, 233),
        ("SemiImplicitEuler", _) => RGBColor(230, 159, 0),
        ("Verlet", _) => RGBColor(0, 114, 178),
        ("Rk4", _) => RGBColor(213, 94, 0),
        _ => RGBColor(0, 158, 115),
    }
}

fn is_exact_kick(forces: &str) -> bool {
    forces.starts_with("Exact") || forces == "SpinDrag"
}
