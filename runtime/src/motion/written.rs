//! Matrices as bytes: their size, then their numbers column by column.

use std::io::{Read, Result, Write};

use borsh::{BorshDeserialize, BorshSerialize};
use nalgebra::{DMatrix, DVector};

pub(super) fn matrix<W: Write>(matrix: &DMatrix<f64>, writer: &mut W) -> Result<()> {
    (matrix.nrows() as u64).serialize(writer)?;
    matrix.as_slice().serialize(writer)
}

pub(super) fn read_matrix<R: Read>(reader: &mut R) -> Result<DMatrix<f64>> {
    let rows = usize::try_from(u64::deserialize_reader(reader)?).unwrap_or(usize::MAX);
    let numbers = Vec::deserialize_reader(reader)?;
    let columns = numbers.len().checked_div(rows).unwrap_or(0);
    if rows.checked_mul(columns) == Some(numbers.len()) {
        return Ok(DMatrix::from_vec(rows, columns, numbers));
    }
    Err(std::io::ErrorKind::InvalidData.into())
}

pub(super) fn vector<W: Write>(vector: &DVector<f64>, writer: &mut W) -> Result<()> {
    vector.as_slice().serialize(writer)
}

pub(super) fn read_vector<R: Read>(reader: &mut R) -> Result<DVector<f64>> {
    Ok(DVector::from_vec(Vec::deserialize_reader(reader)?))
}

pub(super) fn growth<W: Write>(growth: &Option<DMatrix<f64>>, writer: &mut W) -> Result<()> {
    growth.is_some().serialize(writer)?;
    growth.iter().try_for_each(|growth| matrix(growth, writer))
}

pub(super) fn read_growth<R: Read>(reader: &mut R) -> Result<Option<DMatrix<f64>>> {
    let known = bool::deserialize_reader(reader)?;
    known.then(|| read_matrix(reader)).transpose()
}
