//! Links SUNDIALS, where the system has it.

fn main() {
    for library in [
        "cvodes",
        "nvecserial",
        "sunmatrixdense",
        "sunlinsoldense",
        "generic",
    ] {
        println!("cargo::rustc-link-lib=sundials_{library}");
    }
}
