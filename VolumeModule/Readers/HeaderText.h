#ifndef Varimarch_Readers_HeaderText_h
#define Varimarch_Readers_HeaderText_h

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace varimarch
{

/// The lines at the beginning of a file, as text headers have them. A header of more than 4 MB is
/// none, so no more than that is read.
class HeaderLines
{
public:
  explicit HeaderLines(const std::string& path);

  /// The next line without its end (LF or CR LF); nothing behind the last one.
  std::optional<std::string> Next();

  /// Offset in the file of the line that is next.
  std::uint64_t Position() const { return this->position; }

private:
  std::string text;
  std::size_t position = 0;
};

/// The fields of a text header by their keys.
class HeaderFields
{
public:
  void Set(const std::string& key, const std::string& value) { this->fields[key] = value; }
  bool Has(const std::string& key) const { return this->fields.count(key) > 0; }

  /// The value of the first of the keys that there is; empty if there is none.
  std::string Value(const std::vector<std::string>& keys) const;

private:
  std::map<std::string, std::string> fields;
};

std::string LowerCase(std::string text);

/// Without blanks at both ends.
std::string Trimmed(const std::string& text);

/// Whether the value of a field for data files says "LIST": the next lines name them.
bool IsFileList(const std::string& value);

/// The data files that a header names: the listed ones; or those of a printf pattern and its
/// numbers, as in "slice%03d.raw 1 100 1"; or just one. Relative to the header's folder.
/// @throws std::runtime_error for an empty list, or a pattern or numbers that make none
std::vector<std::string> DataFiles(
  const std::string& headerPath, const std::string& value, const std::vector<std::string>& listed);

/// Length of a unit such as "um" or "mm" [mm]; 1 for one that is not known.
double MmPerUnit(const std::string& unit);

}

#endif
