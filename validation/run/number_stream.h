#pragma once

#include <cstdint>
#include <istream>
#include <stdexcept>
#include <string>
#include <vector>

namespace fairlight {

/// Input that holds no numbers in the declared form. The program exits with status 2. A NaN or an
/// infinity is a number that was read: it is a finding of the test, not bad input.
struct BadInput : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// How numbers are written. Binary numbers have the byte order of the machine.
enum class NumberFormat { text, f32, f64 };

/// Reads rows of numbers from a stream, in blocks and in bounded memory. In text, a row is a line;
/// spaces, tabs, commas or semicolons separate columns; blank lines and what follows a # are
/// skipped; lines end with LF or CRLF. The decimal sign is a point in every locale.
class NumberStream {
 public:
  /// `columns` is the number of columns of binary rows; text with 0 columns takes the number that
  /// its first row has. `name` is what messages call the stream. Throws BadInput for a stream
  /// without numbers, and for a first row that cannot be read.
  NumberStream(std::istream& in, NumberFormat format, std::size_t columns, std::string name = "standard input");

  std::size_t columns() const { return columns_; }
  /// The number of rows that `read` has returned.
  std::uint64_t rows() const { return rows_; }

  /// Fills channels[c][i] with column c of the next rows, up to the size of channels[0]; returns
  /// how many rows there were. Throws BadInput, which names the line or the byte.
  std::size_t read(std::vector<std::vector<double>>& channels);

 private:
  bool read_text_row();
  bool next_line();
  void parse_line();
  std::size_t read_binary(std::vector<std::vector<double>>& channels);
  std::size_t read_bytes(char* bytes, std::size_t size);
  [[noreturn]] void fail(const std::string& problem) const;

  std::istream& in_;
  NumberFormat format_;
  std::size_t columns_;
  std::string name_;
  std::uint64_t rows_ = 0;
  std::uint64_t lines_ = 0;
  std::string line_;
  std::vector<double> row_;  // of text: the row that was parsed last
  std::vector<char> bytes_;  // of binary: what was read last
  bool pending_ = false;     // whether the first row was read by the constructor, but not returned
};

}  // namespace fairlight
