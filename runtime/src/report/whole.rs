//! Files that are there whole or not at all.

use std::io::{Error, Result};
use std::path::Path;

/// Writes a file under another name first, so that nothing that ends the program leaves a part of it.
pub(crate) fn write(path: &Path, content: impl AsRef<[u8]>) -> Result<()> {
    let mut growing = path.as_os_str().to_owned();
    growing.push(".part");
    let done = std::fs::write(&growing, content).and_then(|()| std::fs::rename(&growing, path));
    if done.is_err() {
        let _ = std::fs::remove_file(&growing);
    }
    done
}

/// Rows as CSV.
pub(crate) fn csv<R>(rows: impl IntoIterator<Item = R>) -> Result<String>
where
    R: IntoIterator<Item: AsRef<[u8]>>,
{
    let mut writer = csv::Writer::from_writer(Vec::new());
    for row in rows {
        writer.write_record(row)?;
    }
    let bytes = writer
        .into_inner()
        .map_err(csv::IntoInnerError::into_error)?;
    String::from_utf8(bytes).map_err(Error::other)
}
