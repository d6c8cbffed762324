// What menus offer, and on what grounds.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <regex>

#include "app/widgets/choices.hpp"
#include "core/output/csv_table.hpp"
#include "core/scene/choices.hpp"

using namespace pf;
using namespace pf::app;

namespace {

const std::filesystem::path source = PUSHFORWARD_SOURCE;

struct Methods {
  const char* pointer;
  std::span<const Choice> choices;
};
std::vector<Methods> methods() {
  return {{"/grid/basis", basis_choices()},       {"/integrator/type", integrator_choices()},
          {"/integrator/mass", mass_choices()},   {"/transfer/velocity_mass", mass_choices()},
          {"/transfer/type", transfer_choices()}, {"/solver/linear", solver_choices()}};
}

/// Cells of the rows that no cheaper row is as exact as.
std::vector<std::string> front(const CsvTable& table) {
  const int work = table.find("work"), error = table.find("error_l2");
  REQUIRE(std::min(work, error) >= 0);
  struct Row {
    double work, error;
    const std::vector<std::string>* cells;
  };
  std::vector<Row> rows;
  for (const auto& row : table.rows)
    rows.push_back(
        {csv_value(row[static_cast<std::size_t>(work)]), csv_value(row[static_cast<std::size_t>(error)]), &row});
  std::erase_if(rows, [](const Row& row) { return !std::isfinite(row.work + row.error); });
  std::sort(rows.begin(), rows.end(), [](const Row& a, const Row& b) { return a.work < b.work; });
  std::vector<std::string> cells;
  double best = std::numeric_limits<double>::infinity();
  for (const Row& row : rows) {
    if (!(row.error < best)) continue;
    best = row.error;
    cells.insert(cells.end(), row.cells->begin(), row.cells->end());
  }
  return cells;
}

}  // namespace

TEST_CASE("every method that a menu offers says which study or lesson it is there for, and that exists") {
  const std::regex study("stud(?:y|ies) ([a-z, -]+)"), name("[a-z-]+");
  int hidden = 0;
  for (const Methods& m : methods())
    for (const Choice& choice : m.choices) {
      CAPTURE(choice.name);
      const std::string help = choice_help(m.pointer, choice.name);
      CHECK(choice_label(m.pointer, choice.name) != choice.name);
      if (!choice_offered(m.pointer, choice.name)) {
        ++hidden;
        continue;
      }
      if (choice.name == "auto") continue;
      REQUIRE(help.find("Why it is offered: ") != std::string::npos);
      const std::string why = help.substr(help.find("Why it is offered: "));
      CHECK((why.find("stud") != std::string::npos || why.find("lesson ") != std::string::npos));
      for (std::sregex_iterator it(why.begin(), why.end(), study), end; it != end; ++it) {
        const std::string list = (*it)[1];
        for (std::sregex_iterator n(list.begin(), list.end(), name); n != end; ++n) {
          CAPTURE(n->str());
          CHECK(std::filesystem::exists(source / "assets/studies" / (n->str() + ".json")));
        }
      }
    }
  CHECK(hidden == 3);
}

TEST_CASE("what is said to stand on a study's front stands there") {
  const std::regex said("on the front of study ([a-z-]+)");
  int found = 0;
  for (const Methods& m : methods())
    for (const Choice& choice : m.choices) {
      const std::string help = choice_help(m.pointer, choice.name);
      std::smatch match;
      if (!std::regex_search(help, match, said)) continue;
      ++found;
      CAPTURE(choice.name);
      CAPTURE(match[1].str());
      const std::vector<std::string> cells = front(read_csv(source / "docs/images/charts" / (match[1].str() + ".csv")));
      CHECK(std::any_of(cells.begin(), cells.end(),
                        [&](const std::string& cell) { return cell.find(choice.name) != std::string::npos; }));
    }
  CHECK(found >= 8);
}
