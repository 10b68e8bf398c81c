//! Instructions per body and step, counted by callgrind where it is installed.
//!
//! The program runs itself under valgrind and makes every job twice, with [`STEPS`] steps and with twice as
//! many; what both have in common (first-step work, the call) cancels in the difference. Callgrind counts
//! inside [`window`] only, and writes what it has counted each time that is called, and at the end.

use std::fs;
use std::hint::black_box;
use std::path::Path;
use std::process::{Command, Stdio};

use crate::engine::{self, Scene};
use crate::problem::{ALL, STARTS};

/// In the shorter run.
const STEPS: u32 = 60;
/// At which jobs are counted: the work of a step does not depend on its length.
const RATE: u32 = 60;
/// The argument by which the program asks itself to make the jobs.
pub const ARGUMENT: &str = "--counted";

/// The only part that is counted; what is behind the call keeps it from becoming a jump.
#[inline(never)]
fn window(scene: &mut dyn Scene, steps: u32) {
    scene.advance(steps);
    black_box(steps);
}

/// Makes every job: problems, engines and settings in order, as [`all`] reads them.
pub fn make() {
    let engines = engine::all();
    for kind in ALL {
        for engine in &engines {
            for setting in engine.settings(kind) {
                for steps in [STEPS, 2 * STEPS] {
                    window(&mut *engine.build(kind, setting, RATE), steps);
                }
            }
        }
    }
}

/// Of every job, in order; `None` without valgrind.
pub fn all() -> Option<Vec<f64>> {
    let folder = std::env::temp_dir().join(format!("peers-{}", std::process::id()));
    fs::create_dir_all(&folder).ok()?;
    let counts = run(&folder);
    let _ = fs::remove_dir_all(&folder);
    counts
}

fn run(folder: &Path) -> Option<Vec<f64>> {
    let out = folder.join("out");
    let status = Command::new("valgrind")
        .arg("--tool=callgrind")
        .arg(format!("--callgrind-out-file={}", out.display()))
        .args(
            ["--toggle-collect", "--dump-before"]
                .map(|flag| format!("{flag}=peers::count::window")),
        )
        .arg(std::env::current_exe().ok()?)
        .arg(ARGUMENT)
        .stdout(Stdio::null())
        .stderr(Stdio::null())
        .status()
        .ok()?;
    // The first file was written before the first window; the last has no number.
    let mut dumps: Vec<f64> = (2..)
        .map_while(|i| fs::read_to_string(folder.join(format!("out.{i}"))).ok())
        .map(|text| total(&text).unwrap_or(f64::NAN))
        .collect();
    dumps.push(total(&fs::read_to_string(out).ok()?)?);
    status.success().then(|| {
        dumps
            .chunks_exact(2)
            .map(|pair| (pair[1] - pair[0]) / (f64::from(STEPS) * STARTS as f64))
            .collect()
    })
}

/// The sum of a callgrind file.
fn total(text: &str) -> Option<f64> {
    let line = text.lines().find_map(|line| line.strip_prefix("totals:"))?;
    line.trim().parse().ok()
}

#[cfg(test)]
mod tests {
    #[test]
    fn a_sum_is_read_or_missed() {
        assert_eq!(super::total("a: 1\ntotals: 4096\n"), Some(4096.0));
        assert_eq!(super::total("summary: 4096\n"), None);
        assert_eq!(super::total("totals: \n"), None);
    }
}
