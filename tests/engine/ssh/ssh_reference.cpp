#include "tests/engine/ssh/ssh_reference.hpp"

#include <algorithm>
#include <functional>
#include <map>
#include <numeric>
#include <ranges>
#include <set>
#include <sstream>
#include <string>

#include "core/random.hpp"
#include "tests/axioms/forward_chaining.hpp"
#include "tests/engine/seeded_walk.hpp"
#include "tests/engine/ssh/basic_ssh.hpp"

namespace asterism {
namespace {

using Kind = Action::Kind;
using Edges = std::vector<std::pair<std::size_t, std::size_t>>;

/// The least number of the dstates joined to each by these kinds of action.
Naming classes(const Experience& experience, const Naming& naming, const std::set<Kind>& kinds) {
  Naming least(naming.size());
  std::iota(least.begin(), least.end(), std::size_t{0});
  for (bool changed = true; changed;) {
    changed = false;
    for (std::size_t k = 1; k < naming.size(); ++k) {
      if (!kinds.contains(experience.actions[k - 1].kind)) continue;
      std::size_t& a = least[naming[k - 1]];
      std::size_t& b = least[naming[k]];
      changed |= a != b;
      a = b = std::min(a, b);
    }
  }
  return least;
}

std::size_t number_of(const Naming& naming, const Naming& least) {
  std::set<std::size_t> different;
  for (const std::size_t dstate : naming) different.insert(least[dstate]);
  return different.size();
}

/// V - E + F - 2 (parts) is 0, with these orders of the edge ends at each vertex.
bool is_embedding(const Edges& edges, const std::vector<std::vector<std::size_t>>& order) {
  // End 2 e leaves the first vertex of edge e, end 2 e + 1 the second.
  std::vector<std::size_t> next(2 * edges.size());
  for (const auto& ends : order)
    for (std::size_t i = 0; i < ends.size(); ++i) next[ends[i]] = ends[(i + 1) % ends.size()];
  std::vector<bool> seen(next.size());
  std::size_t faces = 0;
  for (std::size_t end = 0; end < next.size(); ++end) {
    if (seen[end]) continue;
    ++faces;
    for (std::size_t at = end; !seen[at]; at = next[at ^ 1]) seen[at] = true;
  }
  std::size_t vertices = 0;
  for (const auto& ends : order) vertices += ends.empty() ? 0U : 1U;
  std::vector<std::size_t> part(order.size());
  std::iota(part.begin(), part.end(), std::size_t{0});
  for (std::size_t round = 0; round < part.size(); ++round)
    for (const auto& [a, b] : edges) part[a] = part[b] = std::min(part[a], part[b]);
  std::set<std::size_t> parts;
  for (std::size_t v = 0; v < order.size(); ++v)
    if (!order[v].empty()) parts.insert(part[v]);
  return vertices + faces == edges.size() + 2 * parts.size();
}

}  // namespace

std::vector<Fact> plain_facts(const Experience& experience, const Naming& naming) {
  const auto dstate = [&](std::size_t k) { return "q" + std::to_string(naming[k]); };
  std::vector<Fact> facts{{"is_turn", {"turn_around"}}};
  for (std::size_t k = 0; k < naming.size(); ++k) {
    facts.push_back({"sees", {dstate(k), experience.views[k]}});
    if (k == 0) continue;
    const Action& action = experience.actions[k - 1];
    const bool is_turn = action.kind == Kind::turn;
    const std::string name = is_turn ? "turn_" + action.turn : action.text();
    facts.push_back({"leads", {dstate(k - 1), name, dstate(k)}});
    if (is_turn) facts.push_back({"is_turn", {name}});
  }
  return facts;
}

std::vector<Naming> every_partition(std::size_t views) {
  std::vector<Naming> result{{}};
  for (std::size_t k = 0; k < views; ++k) {
    std::vector<Naming> longer;
    for (const Naming& naming : result) {
      const std::size_t known =
          naming.empty() ? 0 : *std::max_element(naming.begin(), naming.end()) + 1;
      for (std::size_t dstate = 0; dstate <= known; ++dstate) {
        longer.push_back(naming);
        longer.back().push_back(dstate);
      }
    }
    result = std::move(longer);
  }
  return result;
}

std::vector<Naming> every_ssh_map(const Experience& experience) {
  std::vector<Naming> result;
  for (const Naming& naming : every_partition(experience.views.size())) {
    // Spares the chaining most of its work: where two views differ, it refutes them.
    std::map<std::size_t, std::string> seen;
    const bool one_view =
        std::ranges::all_of(std::views::iota(std::size_t{0}, naming.size()), [&](std::size_t k) {
          return seen.emplace(naming[k], experience.views[k]).first->second == experience.views[k];
        });
    if (one_view &&
        ForwardChaining(plain_facts(experience, naming)).verdict() == Verdict::consistent)
      result.push_back(naming);
  }
  return result;
}

std::pair<std::size_t, std::size_t> plain_extents(const Experience& experience,
                                                  const Naming& naming) {
  return {number_of(naming, classes(experience, naming, {Kind::travel, Kind::turn_around})),
          number_of(naming, classes(experience, naming, {Kind::turn, Kind::turn_around}))};
}

bool has_plane_embedding(std::size_t vertices, const Edges& edges) {
  std::vector<std::vector<std::size_t>> order(vertices);
  for (std::size_t e = 0; e < edges.size(); ++e) {
    order[edges[e].first].push_back(2 * e);
    order[edges[e].second].push_back(2 * e + 1);
  }
  // One end stands first at each vertex, the others in every order.
  const std::function<bool(std::size_t)> turn = [&](std::size_t v) -> bool {
    if (v == vertices) return is_embedding(edges, order);
    if (order[v].size() < 3) return turn(v + 1);
    std::sort(order[v].begin() + 1, order[v].end());
    do {
      if (turn(v + 1)) return true;
    } while (std::next_permutation(order[v].begin() + 1, order[v].end()));
    return false;
  };
  return turn(0);
}

bool has_plane_embedding(const Experience& experience, const Naming& naming) {
  const Naming places = classes(experience, naming, {Kind::turn, Kind::turn_around});
  std::set<std::pair<std::size_t, std::size_t>> joined;
  for (std::size_t k = 1; k < naming.size(); ++k)
    if (experience.actions[k - 1].kind == Kind::travel)
      joined.insert(std::minmax(places[naming[k - 1]], places[naming[k]]));
  return has_plane_embedding(naming.size(), {joined.begin(), joined.end()});
}

Experience experience(const std::string& text) {
  Experience result{.name = "t", .views = {}, .actions = {}};
  std::istringstream words(text);
  for (std::string word; words >> word;) {
    if (result.views.size() == result.actions.size())
      result.views.push_back(word);
    else
      result.actions.push_back(Action::parse(word));
  }
  return result;
}

Experience tour(const std::vector<std::size_t>& places) {
  Experience result{.name = "tour", .views = {}, .actions = {}};
  for (std::size_t i = 0; i < places.size(); ++i) {
    const std::string step = std::to_string(i);
    result.views.push_back("place" + std::to_string(places[i]));
    if (i + 1 == places.size()) break;
    result.actions.push_back({Action::Kind::turn, "off" + step});
    result.views.push_back("off" + step);
    result.actions.push_back({Action::Kind::travel});
    result.views.push_back("arrived" + step);
    result.actions.push_back({Action::Kind::turn, "in" + step});
  }
  return result;
}

Naming of_few_dstates(const Experience& seen) {
  std::map<std::string, std::size_t> known;
  Naming result;
  for (const std::string& view : seen.views)
    result.push_back(known.emplace(view, known.size()).first->second);
  return result;
}

Experience seeded_experience(unsigned seed, std::size_t views) {
  RandomEngine engine(seed);
  Experience result{.name = "red-" + std::to_string(seed), .views = {}, .actions = {}};
  if (seed % 4 != 0) {
    const Experience walked = basic_ssh(seeded_walk(seed, views).trace);
    const std::size_t kinds = seed % 4 == 3 ? 100 : seed % 4;
    for (std::size_t k = 0; k < views; ++k) {
      const unsigned long view = std::stoul(walked.views.at(k).substr(1)) % kinds;
      result.views.push_back("v" + std::to_string(view));
      if (k > 0) result.actions.push_back(walked.actions[k - 1]);
    }
    return result;
  }
  const std::size_t kinds = 1 + below(3, engine);
  for (std::size_t k = 0; k < views; ++k) {
    result.views.push_back("v" + std::to_string(below(kinds, engine)));
    if (k == 0) continue;
    const double which = uniform(engine);
    if (which < 0.45)
      result.actions.push_back({Kind::travel});
    else if (which < 0.7)
      result.actions.push_back({Kind::turn_around});
    else
      result.actions.push_back({Kind::turn, which < 0.85 ? "left" : "right"});
  }
  return result;
}

}  // namespace asterism
