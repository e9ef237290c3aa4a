//! `cargo bessemer new --template`: each package is simulated, generated, and its stub compiles. Each run tries one.

use std::fs;
use std::process::Command;

use bessemer_tests::workspace::Workspace;
use bessemer_tests::{toolchain, turn};
use cargo_bessemer::args::{New, Template};
use cargo_bessemer::new;

#[test]
fn a_template_is_simulated_and_generated() {
    let all = [
        ("axis", Template::Drive, "current_loop_step"),
        ("altitude", Template::Estimator, "sensor_monitor_step"),
        ("convoy", Template::Vehicle, "lane_step"),
    ];
    for (name, template, entry) in turn::one_of(all.to_vec()) {
        let workspace = Workspace::for_package(name).expect("a workspace");
        let template = Some(template);
        let wanted = New { name: name.to_owned(), template, path: Some(".".into()), git: None };
        new::run(&workspace.path(""), &wanted).expect("it is new");
        let package = workspace.path(name);
        let passed = workspace.run_test(&package, "closed_loop");
        passed.unwrap_or_else(|said| panic!("{name}: {said}"));
        if template == Some(Template::Vehicle) {
            let _alone = workspace.alone().expect("the target folder");
            let mut campaign = Command::new(std::env::var_os("CARGO").unwrap_or("cargo".into()));
            let words =
                "run --quiet --offline --example campaign -- --seeds 0..2 --json --file two.csv";
            campaign.args(words.split(' ')).current_dir(&package);
            let said =
                toolchain::run(&mut campaign).map(|()| fs::read_to_string(package.join("two.csv")));
            let rows = said.unwrap_or_else(|said| panic!("{name}: {said}")).expect("the rows");
            assert_eq!(rows.lines().count(), 4, "{rows}");
        }
        let said =
            super::generated(&package, false).unwrap_or_else(|said| panic!("{name}: {said}"));
        assert!(said.contains(entry), "{said}");
        if let Some(gcc) = toolchain::host().into_iter().find(|it| it.level == 2) {
            let sources = fs::read_dir(package.join("generated")).expect("the C").flatten();
            let sources =
                sources.map(|it| it.path()).filter(|it| it.extension().is_some_and(|it| it == "c"));
            let mut compile = gcc.command();
            compile.arg("-Igenerated").arg("firmware/main.c").args(sources);
            compile.args(["-lm", "-o", "stub"]).current_dir(&package);
            toolchain::run(&mut compile).unwrap_or_else(|said| panic!("{name}: {said}"));
            let output = Command::new(package.join("stub")).output().expect("it runs");
            assert!(output.status.success() && !output.stdout.is_empty(), "{name}");
        }
    }
}
