#pragma once

#include <cstddef>
#include <iosfwd>
#include <string>
#include <string_view>

#include "core/search_state.hpp"
#include "core/theory_record.hpp"
#include "core/trace.hpp"

namespace asterism {

/// A search for minimal models, to go on with later: where it stands, and of what it is.
struct Checkpoint {
  /// What must be the same for the state to mean the same.
  struct Search {
    std::string trace;   ///< its name
    std::string digest;  ///< of all that the trace tells: see io/json/digest.hpp
    TheoryRecord theory = {};
    friend bool operator==(const Search&, const Search&) = default;
  };
  Search search;
  SearchState state;
};

/// Of a file that is read.
inline constexpr std::size_t max_checkpoint_bytes = std::size_t{1} << 30;

/// Writes a checkpoint, a model or a branch to a line.
/// @throws std::invalid_argument if a string is not UTF-8
void write_checkpoint(std::ostream& out, const Checkpoint& checkpoint);

/// Writes a checkpoint to the disk, whole or not at all.
/// @throws std::invalid_argument as write_checkpoint, Error if the file cannot be written
void write_checkpoint_file(const std::string& file, const Checkpoint& checkpoint);

/// Reads a checkpoint as write_checkpoint writes it. Whether the state is one of its search, the
/// search must say.
/// @throws InputError "file:/json/pointer: found ...; expected ..."; for what is not JSON
///         "file:line:column: ..."
Checkpoint read_checkpoint(std::string_view json_text, const std::string& file_name);

/// Reads a file of a checkpoint.
/// @throws InputError as read_checkpoint, and if the file cannot be read or exceeds
/// max_checkpoint_bytes
Checkpoint read_checkpoint_file(const std::string& file);

/// Refuses a checkpoint of another search.
/// @throws InputError that names the first difference
void require_same_search(const Checkpoint& checkpoint, const Checkpoint::Search& expected,
                         const std::string& file_name);

}  // namespace asterism
