//! Methods for comparison as values of options: by name, each with its line in `--help`.

use clap::builder::{PossibleValue, PossibleValuesParser, TypedValueParser};

/// Takes the name of one of some methods; the first is what is done if none is named.
pub(super) fn of<M: Copy + Send + Sync>(
    all: &'static [M],
    name: fn(M) -> &'static str,
    about: fn(M) -> &'static str,
) -> impl TypedValueParser<Value = M> {
    let values = all.iter().map(move |method| PossibleValue::new(name(*method)).help(about(*method)));
    PossibleValuesParser::new(values).try_map(move |given| {
        // clap has looked it up already, and would have said which there are.
        all.iter().copied().find(|method| name(*method) == given).ok_or("no such method")
    })
}
