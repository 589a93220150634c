#ifndef Varimarch_Viewer_Log_h
#define Varimarch_Viewer_Log_h

#include <QString>

#include <cstddef>
#include <initializer_list>

namespace varimarch
{

/// A text that stands in the source of the program.
class Literal
{
public:
  template <std::size_t size>
  constexpr Literal(const char (&text)[size])
    : text(text)
  {
  }

  const char* Text() const { return this->text; }

private:
  const char* text;
};

struct LogNumber
{
  Literal name;
  double value;
};

/// Begins a log of what the program does, in a folder that is made when it is missing: a file of at
/// most half a megabyte, and the last three before it. Warnings of Qt and VTK are noted as well, by
/// the place in the source that they come from.
///
/// Nothing of a patient gets into it, neither names nor places of files: an entry is made of words
/// that stand in the source, and of numbers.
void StartLog(const QString& folder);

/// The file that StartLog begins in a folder.
QString LogFileIn(const QString& folder);

/// Notes an event; nothing without a log.
void LogEvent(Literal event, std::initializer_list<LogNumber> numbers = {});

}

#endif
