#ifndef Varimarch_Viewer_WordsEditor_h
#define Varimarch_Viewer_WordsEditor_h

#include <QPointF>
#include <QString>

#include <functional>

class QWidget;

namespace varimarch
{

/// Shows a line to type words into, over a view. Return, or a click elsewhere, takes them; Esc
/// takes no words. The view owns the line.
void AskForWordsOver(
  QWidget* view, const QPointF& place, const std::function<void(const QString&)>& take);

}

#endif
