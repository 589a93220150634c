#ifndef Varimarch_Viewer_NumberText_h
#define Varimarch_Viewer_NumberText_h

#include <QLocale>
#include <QString>

namespace varimarch
{

/// A number for display, written as in the user's language. Files hold numbers as in C.
inline QString NumberText(double number, int decimals)
{
  return QLocale().toString(number, 'f', decimals);
}

}

#endif
