#include <algorithm>
#include <charconv>
#include <cstring>

#include <fairlight/stats/text.h>
#include <fairlight/validation/run/number_stream.h>

namespace fairlight {
namespace {

constexpr std::size_t longest_line = 1 << 16;

bool separates(char c) { return c == ' ' || c == '\t' || c == ',' || c == ';' || c == '\r'; }

// The word that begins at `begin`, shortened for a message.
std::string quoted(const char* begin, const char* end) {
  constexpr std::ptrdiff_t longest = 40;
  const auto shown = static_cast<int>(std::min(end - begin, longest));
  return formatted("\"%.*s%s\"", shown, begin, end - begin > longest ? "..." : "");
}

template <class Number>
void unpack(const std::vector<char>& bytes, std::size_t rows, std::vector<std::vector<double>>& channels) {
  const char* at = bytes.data();
  for (std::size_t i = 0; i < rows; ++i) {
    for (auto& channel : channels) {
      Number x;
      std::memcpy(&x, at, sizeof x);
      channel[i] = static_cast<double>(x);
      at += sizeof x;
    }
  }
}

}  // namespace

NumberStream::NumberStream(std::istream& in, NumberFormat format, std::size_t columns, std::string name)
    : in_(in), format_(format), columns_(columns), name_(std::move(name)) {
  if (format == NumberFormat::text) {
    pending_ = read_text_row();
  } else {
    columns_ = std::max<std::size_t>(columns, 1);
    pending_ = in_.peek() != std::istream::traits_type::eof();
  }
  if (!pending_) throw BadInput(name_ + " holds no numbers (pipe the draws of a program into it)");
  if (format != NumberFormat::text) pending_ = false;
}

void NumberStream::fail(const std::string& problem) const {
  throw BadInput(
      formatted("line %llu of %s %s", static_cast<unsigned long long>(lines_), name_.c_str(), problem.c_str()));
}

// Bounds the memory that a line takes: a file without line ends is no text of numbers.
bool NumberStream::next_line() {
  line_.resize(longest_line);
  in_.getline(line_.data(), static_cast<std::streamsize>(longest_line));
  const auto read = static_cast<std::size_t>(in_.gcount());
  if (read == 0 && !in_.good()) return false;
  ++lines_;
  if (in_.fail() && !in_.eof()) fail("is longer than 65535 characters (write one row a line)");
  line_.resize(in_.eof() ? read : read - 1);  // gcount counts the line end
  return true;
}

void NumberStream::parse_line() {
  row_.clear();
  const char* at = line_.data();
  const char* const end = std::find(at, at + line_.size(), '#');
  for (;;) {
    while (at != end && separates(*at)) ++at;
    if (at == end) return;
    const char* const word_end = std::find_if(at, end, separates);
    const char* const digits = *at == '+' && word_end - at > 1 && at[1] != '-' ? at + 1 : at;
    double x = 0;
    const auto [stop, error] = std::from_chars(digits, word_end, x);
    if (error == std::errc::result_out_of_range)
      fail("holds " + quoted(at, word_end) + ", which a double cannot hold (rescale the draws)");
    if (error != std::errc() || stop != word_end)
      fail("holds " + quoted(at, word_end) + ", which is not a number (write numbers such as 0.25 or 1e-3)");
    row_.push_back(x);
    at = word_end;
  }
}

bool NumberStream::read_text_row() {
  do {
    if (!next_line()) return false;
    parse_line();
  } while (row_.empty());
  if (columns_ == 0) columns_ = row_.size();
  if (row_.size() != columns_)
    fail(formatted("has %zu columns where %zu are expected (a decimal sign is a point; commas separate columns)",
                   row_.size(), columns_));
  return true;
}

std::size_t NumberStream::read_bytes(char* bytes, std::size_t size) {
  in_.read(bytes, static_cast<std::streamsize>(size));
  return static_cast<std::size_t>(in_.gcount());
}

std::size_t NumberStream::read_binary(std::vector<std::vector<double>>& channels) {
  const bool single = format_ == NumberFormat::f32;
  const std::size_t row_size = columns_ * (single ? sizeof(float) : sizeof(double));
  const std::size_t wanted = channels[0].size() * row_size;
  const bool direct = !single && columns_ == 1;
  if (!direct) bytes_.resize(wanted);
  char* const place = direct ? reinterpret_cast<char*>(channels[0].data()) : bytes_.data();
  const std::size_t got = read_bytes(place, wanted);
  if (got % row_size != 0)
    throw BadInput(formatted("%s ends %zu bytes into row %llu, which has %zu bytes (see --format and --columns)",
                             name_.c_str(), got % row_size, static_cast<unsigned long long>(rows_ + got / row_size),
                             row_size));
  if (!direct && single) unpack<float>(bytes_, got / row_size, channels);
  if (!direct && !single) unpack<double>(bytes_, got / row_size, channels);
  return got / row_size;
}

std::size_t NumberStream::read(std::vector<std::vector<double>>& channels) {
  std::size_t n = 0;
  if (format_ != NumberFormat::text) {
    n = read_binary(channels);
  } else {
    for (; n < channels[0].size(); ++n) {
      if (!pending_ && !read_text_row()) break;
      pending_ = false;
      for (std::size_t c = 0; c < columns_; ++c) channels[c][n] = row_[c];
    }
  }
  rows_ += n;
  return n;
}

}  // namespace fairlight
