#pragma once

#include "axioms/formula_reader.hpp"

namespace asterism {

/// Reads the declaration of an extent. Its variables are of sort DState, at most four, each in a
/// term or in the premise; its terms are of one sort.
///
///     (set-info :extent (NAME ((x DState) ...) TERM ...))
///     (set-info :extent (NAME ((x DState) ...) :where PREMISE TERM ...))
///
/// @throws InputError with file and line
ExtentDeclaration read_extent(const SExpr& form, const FormulaReader& words);

}  // namespace asterism
