//! Methods for comparison as values of options: by name, each with its line in `--help`.

use core::error::Error;
use core::str::FromStr;

use clap::builder::{PossibleValue, PossibleValuesParser, TypedValueParser};

/// Takes the name of one of some methods; the first is what is done if none is named.
pub(super) fn of<M: Copy + Send + Sync + FromStr<Err: Error + Send + Sync + 'static>>(
    all: &'static [M],
    name: fn(M) -> &'static str,
    about: fn(M) -> &'static str,
) -> impl TypedValueParser<Value = M> {
    let values = all.iter().map(move |method| PossibleValue::new(name(*method)).help(about(*method)));
    PossibleValuesParser::new(values).try_map(|given| given.parse::<M>())
}
