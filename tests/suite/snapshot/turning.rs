//! A scene of bodies that turn: a motor, springs off the centre, a wind with a torque, a bearing.

use fixstep::rigid::torque::{Attached, SpinDrag, Torque, Wrench};
use fixstep::{
    BodyId, Decay, Force, GravityY, Pairs, PerBody, Rotating, Scalar, Spring, Time, dec, heapless,
    vec2,
};

use super::cast::Cast;
use super::scenes::{FIRST, Scene, named};

pub fn turning<B: Cast + Rotating<S: Decay>>(world: &Scene<B>) -> impl Force<B> + use<B> {
    let wind = |_: Time, body: &B| {
        let pull = B::S::ratio(dec!(-0.07)).unwrap().coef();
        let arm = body.rotation().rotate(vec2(dec!(0.3), dec!(0.1)).unwrap());
        Wrench::at(arm, body.position().scaled(pull))
    };
    let mut ties = heapless::Vec::<[BodyId; 2], FIRST>::new();
    for pair in [[0, 1], [1, 2], [3, 4]] {
        if let [Some(one), Some(other)] = pair.map(|serial| named(world, serial)) {
            ties.push([one, other]).unwrap();
        }
    }
    let tie = Attached {
        spring: Spring::new(2, dec!(1.9), dec!(0.3)).unwrap(),
        at: [
            vec2(dec!(0.4), 0).unwrap(),
            vec2(dec!(-0.2), dec!(0.3)).unwrap(),
        ],
    };
    let torque = B::S::ratio(dec!(0.11)).unwrap();
    (
        GravityY::new(dec!(-0.09)).unwrap(),
        PerBody(wind),
        named(world, 1).map(|body| Torque { body, torque }),
        Pairs::new(tie, ties),
        SpinDrag::new(dec!(0.05)).unwrap(),
    )
}
