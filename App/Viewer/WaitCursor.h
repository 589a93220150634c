#ifndef Varimarch_Viewer_WaitCursor_h
#define Varimarch_Viewer_WaitCursor_h

#include <QGuiApplication>

namespace varimarch
{

/// Shows, while it exists, that the program does not react.
class WaitCursor
{
public:
  WaitCursor() { QGuiApplication::setOverrideCursor(Qt::WaitCursor); }
  ~WaitCursor() { QGuiApplication::restoreOverrideCursor(); }
  WaitCursor(const WaitCursor&) = delete;
  WaitCursor& operator=(const WaitCursor&) = delete;
};

}

#endif
