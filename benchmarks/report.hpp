#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace asterism {

/// What the benchmarks found: Markdown tables, and counts that were not as expected.
class Report {
 public:
  /// Progress goes to `stderr`, table by table.
  void begin_table(std::string_view title, const std::vector<std::string>& columns);
  void add_row(const std::vector<std::string>& cells);
  void add_text(std::string_view text);

  /// Takes note where a count is not as expected; none at all is no fault.
  void check(std::string_view what, std::optional<std::uint64_t> found, std::uint64_t expected);

  /// Takes note where something that must hold does not.
  void require(bool holds, std::string_view what);

  const std::string& markdown() const { return markdown_; }
  bool counts_agree() const { return counts_agree_; }

 private:
  std::string markdown_;
  bool counts_agree_ = true;
};

/// Three significant digits, in the unit that suits: "1.66 ms".
std::string duration_text(double seconds);
/// "100,122"
std::string count_text(std::uint64_t count);
/// Two significant digits: "4,700 ×".
std::string ratio_text(double ratio);

}  // namespace asterism
