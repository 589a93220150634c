#ifndef Varimarch_Viewer_Log_h
#define Varimarch_Viewer_Log_h

#include <QString>

#include <cstddef>
#include <initializer_list>

namespace varimarch
{

/// A string literal of the source code.
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

/// Starts the log in a folder, which is created if missing. The log is a file of at most half a
/// megabyte; the three previous files are kept. Warnings of Qt and VTK are logged by their place in
/// the source code.
///
/// The log contains no patient data, neither names nor file paths: an entry consists of string
/// literals of the source code and of numbers.
void StartLog(const QString& folder);

/// Path of the log file that StartLog creates in a folder.
QString LogFileIn(const QString& folder);

/// Logs an event. Does nothing if no log was started.
void LogEvent(Literal event, std::initializer_list<LogNumber> numbers = {});

}

#endif
