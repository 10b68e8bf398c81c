//! Vectors to and from mint, the common vector types of Rust's maths crates.

use mint::{IntoMint, Point2, Vector2};

use crate::vec2::Vec2;

macro_rules! converts {
    ($mint:ident) => {
        impl<S> From<$mint<S>> for Vec2<S> {
            fn from(v: $mint<S>) -> Vec2<S> {
                Vec2 { x: v.x, y: v.y }
            }
        }

        impl<S> From<Vec2<S>> for $mint<S> {
            fn from(v: Vec2<S>) -> $mint<S> {
                $mint { x: v.x, y: v.y }
            }
        }
    };
}

converts!(Vector2);
converts!(Point2);

impl<S> IntoMint for Vec2<S> {
    type MintType = Vector2<S>;
}
