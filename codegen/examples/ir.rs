use bessemer_codegen::generate::{Job, compiled};
fn main() {
    let root = std::env::current_dir().unwrap();
    let job = Job::new(root, "models");
    let made = compiled(&job).map_err(|e| e.to_string()).unwrap();
    std::fs::write("/tmp/module.ir", bessemer_ir::text::print(&made.compiled.module)).unwrap();
    let (explicit, _) = bessemer_backend::passes::explicit(made.compiled.module.clone()).unwrap();
    std::fs::write("/tmp/explicit.ir", bessemer_ir::text::print(&explicit)).unwrap();
}
