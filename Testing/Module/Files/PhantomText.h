#ifndef PhantomText_h
#define PhantomText_h

#include <locale>
#include <sstream>
#include <string>

/// The values one after the other as text, independent of the locale and without rounding.
template <class... Values>
std::string Text(const Values&... values)
{
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text.precision(17);
  (text << ... << values);
  return text.str();
}

#endif
