#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/pose2.hpp"
#include "core/ranked_map.hpp"

namespace asterism {

// How a report writes numbers and tables. Everything returned is XML.

/// "−1.50": a true minus, and none before zero.
std::string decimals(double value, int digits);
/// "12 345": large counts in groups of three.
std::string count_text(std::uint64_t count);
/// "1 map", "3 maps".
std::string counted(std::uint64_t count, const std::string& word);
/// "0.583", "2·10⁻⁷" where that says more, and no less than "under 10⁻⁹".
std::string probability_text(double probability);
/// e to that power: "1.4", "220 000" or "over a million".
std::string times_text(double logarithm);
/// "places 1 and 5 lie on one spot, 0.02 m apart"
std::string shared_spot_text(const SharedSpot& spot);
/// "visits 1, 6 and visit 5 ought to be one place"
std::string ought_to_be_one_text(const TopologicalMap& map, const SharedSpot& spot);
/// "2 pieces, of visit 0 and of visits 1 to 17"
std::string pieces_text(const TopologicalMap& map);
/// "4.07, −17.20 m, −103.1°"
std::string pose_text(const Pose2& pose);
/// "22 min 45 s"
std::string duration_text(double duration_s);

/// An entry of a list of figures (dl.figures).
std::string figure(const std::string& name, const std::string& value);

/// A column of a table.
struct Column {
  std::string head;
  bool is_number = false;  ///< stands to the right
};

/// A table with a head.
/// @param rows  cells as XML, one a column
std::string table(const std::vector<Column>& columns,
                  const std::vector<std::vector<std::string>>& rows);

/// Content under a summary that folds it away; folded at first if it is long.
std::string folding(const std::string& summary, const std::string& content, bool is_open);

}  // namespace asterism
