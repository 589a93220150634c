#ifndef Varimarch_Readers_Parsing_HeaderText_h
#define Varimarch_Readers_Parsing_HeaderText_h

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace varimarch
{

/// The lines of a text header at the beginning of a file. At most 4 MB are read, since no header is
/// longer.
class HeaderLines
{
public:
  explicit HeaderLines(const std::string& path);

  /// The next line without its line end (LF or CR LF); nothing after the last one.
  std::optional<std::string> Next();

  /// File offset of the next line.
  std::uint64_t Position() const { return this->position; }

  /// True after a last line without a line end, which may have been cut.
  bool EndInALine() const { return this->position > this->text.size(); }

private:
  std::string text;
  std::size_t position = 0;
};

/// The words at the beginning of a file that is in memory, one after another.
class HeaderWords
{
public:
  /// @param path  path for error messages
  /// @param bytes  the file's bytes; must outlive this object
  HeaderWords(const std::string& path, const std::string& bytes)
    : path(path)
    , bytes(bytes)
  {
  }

  /// The next word, and steps over the white space before it and one character of that after it.
  std::string Next();

  /// The next words as numbers.
  /// @param what  description of the number for the error message
  /// @throws std::runtime_error if the next word is not a number
  std::int64_t Integer(const std::string& what);
  double Number(const std::string& what);

  /// Offset of the next word, or of the bytes after the header.
  std::size_t Position() const { return this->position; }

private:
  std::string path;
  const std::string& bytes;
  std::size_t position = 0;
};

/// All bytes of a file.
/// @throws std::runtime_error if it cannot be read or does not fit in memory
std::string WholeFile(const std::string& path);

/// The fields of a text header, by key.
class HeaderFields
{
public:
  void Set(const std::string& key, const std::string& value) { this->fields[key] = value; }
  bool Has(const std::string& key) const { return this->fields.count(key) > 0; }

  /// The value of the first key that exists; empty if none does.
  std::string Value(const std::vector<std::string>& keys) const;

private:
  std::map<std::string, std::string> fields;
};

std::string LowerCase(std::string text);

/// The text without leading and trailing whitespace.
std::string Trimmed(const std::string& text);

/// True if the value of a data file field is "LIST": the next lines then name the files.
bool IsFileList(const std::string& value);

/// The data files that a header names, relative to its folder: the listed ones, those of a printf
/// pattern with numbers such as "slice%03d.raw 1 100 1", or a single one.
/// @throws std::runtime_error for an empty list, or an invalid pattern
std::vector<std::string> DataFiles(
  const std::string& headerPath, const std::string& value, const std::vector<std::string>& listed);

/// Length of a unit such as "um" or "mm" [mm]; 1 for an unknown unit.
double MmPerUnit(const std::string& unit);

/// The same, with a warning for an unknown unit; an empty one is mm.
double MmPerUnitOrWarn(const std::string& unit, std::vector<std::string>& warnings);

}

#endif
