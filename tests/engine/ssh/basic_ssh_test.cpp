#include "tests/engine/ssh/basic_ssh.hpp"

#include <algorithm>

#include "engine/ssh/ssh_engines.hpp"
#include "engine/ssh/ssh_tree.hpp"
#include "tests/engine/seeded_walk.hpp"
#include "tests/engine/ssh/ssh_trees.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/known_traces.hpp"

using namespace asterism;

namespace {

/// Whether the native engine keeps this map, asked view by view.
bool is_kept(const SshTable& table, const std::vector<DStateId>& dstates) {
  SshNative engine(table, {});
  engine.reset({});
  for (const VisitId k : IdRange<VisitId>(dstates.size())) {
    const DStateId dstate = dstates[k.index()];
    const auto children = children_of(engine, k);
    if (std::ranges::find(children, dstate) == children.end()) return false;
    engine.enter(k, dstate, engine.step(k, dstate));
  }
  return dstates.size() == table.views();
}

/// Whether visits to one place of a map are at one place of no more than one other map: those of
/// the basic SSH know no stars, so that two dstates are at one place where a turn has joined them.
bool is_coarser(const SshMap& map, const Experience& seen, const Association& visits) {
  std::size_t k = 0;
  std::vector<std::optional<PlaceId>> place(map.number_of_places());
  for (std::size_t view = 0; view < seen.views.size(); ++view) {
    if (view > 0 && seen.actions[view - 1].kind == Action::Kind::travel) ++k;
    auto& known = place[map.places[map.dstates[view].index()].index()];
    if (known && *known != visits[k].place) return false;
    known = visits[k].place;
  }
  return true;
}

Trace first_visits(const Trace& trace, std::size_t visits) {
  Trace result{.name = trace.name, .visits = {}};
  result.visits.assign(trace.visits.begin(),
                       trace.visits.begin() + static_cast<std::ptrdiff_t>(visits));
  return result;
}

/// All maps of the trace are among those of its basic SSH.
void check_law(const Trace& trace) {
  const SshTable table(basic_ssh(trace));
  tree_of(trace, false).for_each([&](HypothesisId, std::span<const Arrival> arrivals) {
    const auto dstates = basic_ssh_dstates(trace, arrivals);
    CHECK(is_kept(table, dstates));
    CHECK(is_coarser(make_ssh_map(table.experience(), dstates), table.experience(),
                     {arrivals.begin(), arrivals.end()}));
  });
}

}  // namespace

//          b+
//     a- --+-- a+     entered by a-, so facing a+; then a turn, and on
//          b-
TEST_CASE("visits are written down as views, turns and travels", "[engine][ssh]") {
  const Star crossing = Star::parse("a+1 b-1 a-1 b+1");
  const Star stub = Star::parse("a+1 a-0");
  Trace trace{.name = "t", .visits = {}};
  trace.visits.push_back({.star = stub, .left_by = 0});
  trace.visits.push_back({.star = crossing, .entered_by = 2, .left_by = 1});
  trace.visits.push_back({.star = stub, .entered_by = 0, .left_by = 0});
  trace.visits.push_back({.star = crossing, .entered_by = 2, .left_by = 0});
  trace.visits.push_back({.star = stub, .entered_by = 0, .left_by = 0});
  const Experience seen = basic_ssh(trace);
  std::vector<std::string> actions;
  for (const Action& action : seen.actions) actions.push_back(action.text());
  CHECK(actions ==
        std::vector<std::string>{"travel", "turn:1", "travel", "turn_around", "travel", "travel"});
  // A crossing looks the same whichever way one faces; a dead end does not.
  REQUIRE(seen.views.size() == 7);
  CHECK(seen.views[1] == seen.views[2]);
  CHECK(seen.views[2] == seen.views[5]);
  CHECK(seen.views[3] == seen.views[6]);
  CHECK(seen.views[4] == seen.views[0]);
  CHECK(seen.views[0] != seen.views[1]);
  CHECK(seen.views[0] != seen.views[3]);
}

TEST_CASE("the basic SSH of a known trace allows every map that the trace has",
          "[engine][ssh][property]") {
  for (const KnownTrace& known : known_traces())
    for (std::size_t visits = 1; visits <= known.trace.visits.size(); ++visits) {
      INFO(known.trace.name << ", " << visits << " visits");
      check_law(first_visits(known.trace, visits));
    }
}

TEST_CASE("the basic SSH of a walk allows every map that the walk has", "[engine][ssh][property]") {
  for (unsigned seed = 0; seed < 250; ++seed) {
    const Trace trace = seeded_walk(seed, 3 + seed % 7).trace;
    INFO(to_keep(seed, trace));
    check_law(trace);
  }
}

TEST_CASE("the maps of a trace are among those its basic SSH lists", "[engine][ssh][property]") {
  std::size_t more = 0;
  for (unsigned seed = 0; seed < 100; ++seed) {
    const Trace trace = seeded_walk(seed, 3 + seed % 3).trace;
    INFO(to_keep(seed, trace));
    SshTree tree(basic_ssh(trace), {.theory = {.axioms = shipped_with()}});
    REQUIRE(tree.grow(basic_ssh(trace).views.size()) == MapTree::Growth::complete);
    std::vector<std::vector<DStateId>> listed;
    tree.for_each([&](const SshMap& map) { listed.push_back(map.dstates); });
    CHECK(std::ranges::is_sorted(listed));
    const MapTree maps = tree_of(trace, false);
    maps.for_each([&](HypothesisId, std::span<const Arrival> arrivals) {
      CHECK(std::ranges::binary_search(listed, basic_ssh_dstates(trace, arrivals)));
    });
    more += listed.size() - maps.size();
  }
  CHECK(more > 100);  // the basic SSH knows less
}
