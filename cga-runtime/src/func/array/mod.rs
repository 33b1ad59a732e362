//! Arrays in rules: construction, indexing, operators, measures, order.

mod build;
mod each;
mod index;
mod measure;
mod replace;
mod sort;

pub use build::{ArrayPart, array, range_by};
pub use each::{
    Operand, each_add, each_and, each_concat, each_divide, each_equal, each_greater, each_greater_equal, each_less,
    each_less_equal, each_minus, each_multiply, each_not, each_or, each_remainder, each_subtract, each_unequal,
};
pub(super) use each::{each_pair, same_form};
pub use index::{Indices, element, element_at, elements, elements_at};
pub use measure::{count_true, find_element, find_near, join, n_columns, n_rows, size, sum, transpose};
pub use replace::{set_elements, set_elements_at};
pub use sort::{sort_indices, sort_row_indices};
