#include <cmath>

#include <fairlight/stats/text.h>
#include <fairlight/validation/run/law_file.h>
#include <fairlight/validation/run/number_stream.h>

namespace fairlight {
namespace {

constexpr std::size_t most_cells = 1 << 20;

[[noreturn]] void fail(const std::string& name, const NumberStream& rows, const char* problem) {
  throw BadInput(
      formatted("row %llu of %s %s", static_cast<unsigned long long>(rows.rows()), name.c_str(), problem));
}

void add_cell(IntervalLaw& law, double low, double high, double probability, const std::string& name,
              const NumberStream& rows) {
  if (!(std::isfinite(low) && low < high && std::isfinite(high)))
    fail(name, rows, "does not ascend (sort the rows, and give each cell a length)");
  if (!(probability >= 0 && std::isfinite(probability)))
    fail(name, rows, "has a value that is negative or not finite (it is a probability or a density)");
  if (law.edges.empty()) law.edges.push_back(low);
  if (law.edges.back() != low) fail(name, rows, "does not begin where the row before it ends (leave no gap)");
  if (law.probabilities.size() == most_cells) fail(name, rows, "is one too many (a law has at most 2^20 cells)");
  law.edges.push_back(high);
  law.probabilities.push_back(probability);
}

}  // namespace

IntervalLaw read_law(std::istream& in, const std::string& name) {
  NumberStream rows(in, NumberFormat::text, 0, name);
  const std::size_t columns = rows.columns();
  if (columns != 2 && columns != 3)
    throw BadInput(name + " must have rows of low, high, probability, or of x, density");
  IntervalLaw law;
  std::vector<std::vector<double>> row(columns, std::vector<double>(1));
  double x = 0, density = 0;
  while (rows.read(row) == 1) {
    if (columns == 3) {
      add_cell(law, row[0][0], row[1][0], row[2][0], name, rows);
      continue;
    }
    if (!(row[1][0] >= 0)) fail(name, rows, "has a density that is negative or not a number");
    if (rows.rows() > 1) add_cell(law, x, row[0][0], (row[0][0] - x) * (row[1][0] + density) / 2, name, rows);
    x = row[0][0];
    density = row[1][0];
  }
  if (law.probabilities.size() < 2) throw BadInput(name + " has fewer than two cells (no test can be made of one)");
  double sum = 0;
  for (const double p : law.probabilities) sum += p;
  if (!(std::abs(sum - 1) <= 1e-6))
    throw BadInput(formatted("the probabilities of %s sum to %.9g, not to 1 within 1e-6", name.c_str(), sum));
  return law;
}

}  // namespace fairlight
