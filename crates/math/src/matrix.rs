//! Matrices of any size, for those who want to reckon with them.
//!
//! Drawing does not use this module: it composes glam's 4 × 4 matrices, which are as wide as it needs. Here is the
//! general tool: a system to solve, a vector's coordinates in a basis, an oracle for a test. Entries are `f64`, a
//! row is an array, and the sizes are checked by the compiler.
//!
//! ```
//! use polosa_math::Matrix;
//!
//! let a = Matrix::from_rows([[2.0, 1.0], [1.0, 1.0]]);
//! let b = a.inverse().unwrap();
//! assert_eq!(a * b, Matrix::identity());
//! ```

use core::ops::{Add, Index, IndexMut, Mul, Neg, Sub};

/// A matrix of `R` rows and `C` columns. Entry (0, 0) is at the top left.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Matrix<const R: usize, const C: usize> {
    rows: [[f64; C]; R],
}

impl<const R: usize, const C: usize> Matrix<R, C> {
    /// All entries zero.
    pub const ZERO: Self = Self { rows: [[0.0; C]; R] };

    /// From its rows, top to bottom.
    #[must_use]
    pub const fn from_rows(rows: [[f64; C]; R]) -> Self {
        Self { rows }
    }

    /// From its columns, left to right.
    #[must_use]
    pub fn from_columns(columns: [[f64; R]; C]) -> Self {
        Matrix::from_rows(columns).transpose()
    }

    /// From a function of row and column.
    #[must_use]
    pub fn from_fn(mut entry: impl FnMut(usize, usize) -> f64) -> Self {
        Self { rows: core::array::from_fn(|r| core::array::from_fn(|c| entry(r, c))) }
    }

    /// Its rows, top to bottom.
    #[must_use]
    pub const fn rows(&self) -> &[[f64; C]; R] {
        &self.rows
    }

    /// Rows become columns.
    #[must_use]
    pub fn transpose(&self) -> Matrix<C, R> {
        Matrix::from_fn(|r, c| self.rows[c][r])
    }

    /// The largest magnitude of an entry; not a number if an entry is not.
    #[must_use]
    pub fn max_abs(&self) -> f64 {
        let larger = |m: f64, x: &f64| if x.is_nan() || x.abs() > m { x.abs() } else { m };
        self.rows.iter().flatten().fold(0.0, larger)
    }
}

impl<const N: usize> Matrix<N, N> {
    /// Ones on the diagonal, zero elsewhere.
    #[must_use]
    pub fn identity() -> Self {
        Self::from_fn(|r, c| if r == c { 1.0 } else { 0.0 })
    }

    /// The matrix that undoes this one, by Gauss–Jordan elimination with partial pivoting.
    ///
    /// `None` if it is singular as far as rounding can tell (see [`solve`](Self::solve)) or not finite.
    #[must_use]
    pub fn inverse(&self) -> Option<Self> {
        self.solve(&Self::identity())
    }

    /// The X for which `self * X = right`.
    ///
    /// `None` if anything is not finite, or if a pivot is no larger than `N` roundings of what its row and column
    /// started with: what is divided by then would be noise. Scaling a row or a column does not change this
    /// verdict.
    #[must_use]
    pub fn solve<const K: usize>(&self, right: &Matrix<N, K>) -> Option<Matrix<N, K>> {
        let mut a = self.rows;
        let mut x = right.rows;
        // Each row is judged against its own largest entry, each column against its largest entry by that measure.
        let mut row_scale = a.map(|row| Matrix::from_rows([row]).max_abs());
        if row_scale.iter().any(|&s| s == 0.0 || !s.is_finite()) {
            return None;
        }
        let column_scale: [f64; N] =
            core::array::from_fn(|c| (0..N).map(|r| a[r][c].abs() / row_scale[r]).fold(0.0, f64::max));

        for k in 0..N {
            let size = |r: usize| a[r][k].abs() / row_scale[r];
            let pivot = (k..N).fold(k, |best, r| if size(r) > size(best) { r } else { best });
            let enough = size(pivot) > N as f64 * f64::EPSILON * column_scale[k];
            if !enough {
                return None;
            }
            a.swap(k, pivot);
            x.swap(k, pivot);
            row_scale.swap(k, pivot);

            let (pivot_row, right_row) = (a[k], x[k]);
            for r in (0..N).filter(|&r| r != k) {
                let factor = a[r][k] / pivot_row[k];
                for c in k..N {
                    a[r][c] -= factor * pivot_row[c];
                }
                for c in 0..K {
                    x[r][c] -= factor * right_row[c];
                }
            }
        }
        let solution = Matrix::from_fn(|r, c| x[r][c] / a[r][r]);
        solution.max_abs().is_finite().then_some(solution)
    }

    /// The determinant, by elimination with partial pivoting; 1 for the empty matrix.
    #[must_use]
    pub fn determinant(&self) -> f64 {
        let mut a = self.rows;
        let mut determinant = 1.0;
        for k in 0..N {
            let pivot = (k..N).fold(k, |best, r| if a[r][k].abs() > a[best][k].abs() { r } else { best });
            if a[pivot][k] == 0.0 {
                return 0.0;
            }
            if pivot != k {
                a.swap(k, pivot);
                determinant = -determinant;
            }
            determinant *= a[k][k];
            let pivot_row = a[k];
            for row in &mut a[k + 1..] {
                let factor = row[k] / pivot_row[k];
                for c in k..N {
                    row[c] -= factor * pivot_row[c];
                }
            }
        }
        determinant
    }
}

/// The coordinates of `vector` in the basis whose vectors are the columns of `basis`.
///
/// `None` if these do not span the space, as far as rounding can tell ([`Matrix::solve`]).
///
/// ```
/// use polosa_math::{Matrix, coordinates};
///
/// let basis = Matrix::from_columns([[1.0, 1.0], [-1.0, 1.0]]);
/// assert_eq!(coordinates(&basis, [0.0, 2.0]), Some([1.0, 1.0]));
/// ```
#[must_use]
pub fn coordinates<const N: usize>(basis: &Matrix<N, N>, vector: [f64; N]) -> Option<[f64; N]> {
    basis.solve(&Matrix::from_columns([vector])).map(|x| x.transpose().rows[0])
}

impl<const R: usize, const C: usize> Index<(usize, usize)> for Matrix<R, C> {
    type Output = f64;

    /// The entry at (row, column). Panics like an array if there is none.
    fn index(&self, (row, column): (usize, usize)) -> &f64 {
        &self.rows[row][column]
    }
}

impl<const R: usize, const C: usize> IndexMut<(usize, usize)> for Matrix<R, C> {
    fn index_mut(&mut self, (row, column): (usize, usize)) -> &mut f64 {
        &mut self.rows[row][column]
    }
}

impl<const R: usize, const C: usize> Add for Matrix<R, C> {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        Self::from_fn(|r, c| self.rows[r][c] + other.rows[r][c])
    }
}

impl<const R: usize, const C: usize> Sub for Matrix<R, C> {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        Self::from_fn(|r, c| self.rows[r][c] - other.rows[r][c])
    }
}

impl<const R: usize, const C: usize> Neg for Matrix<R, C> {
    type Output = Self;

    fn neg(self) -> Self {
        Self::from_fn(|r, c| -self.rows[r][c])
    }
}

impl<const R: usize, const C: usize, const K: usize> Mul<Matrix<C, K>> for Matrix<R, C> {
    type Output = Matrix<R, K>;

    /// The matrix product; each entry's terms are added from left to right.
    fn mul(self, other: Matrix<C, K>) -> Matrix<R, K> {
        Matrix::from_fn(|r, k| (0..C).fold(0.0, |sum, c| sum + self.rows[r][c] * other.rows[c][k]))
    }
}

impl<const R: usize, const C: usize> Mul<f64> for Matrix<R, C> {
    type Output = Self;

    fn mul(self, factor: f64) -> Self {
        Self::from_fn(|r, c| self.rows[r][c] * factor)
    }
}

impl<const R: usize, const C: usize> Mul<Matrix<R, C>> for f64 {
    type Output = Matrix<R, C>;

    fn mul(self, matrix: Matrix<R, C>) -> Matrix<R, C> {
        matrix * self
    }
}
