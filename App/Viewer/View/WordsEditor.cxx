#include "Viewer/View/WordsEditor.h"

#include <QCoreApplication>
#include <QLineEdit>
#include <QShortcut>

#include <algorithm>

namespace varimarch
{

namespace
{

struct EditorTexts
{
  Q_DECLARE_TR_FUNCTIONS(WordsEditor)
};

}

void AskForWordsOver(
  QWidget* view, const QPointF& place, const std::function<void(const QString&)>& take)
{
  auto* const line = new QLineEdit(view);
  line->setPlaceholderText(EditorTexts::tr("Words"));
  line->setAccessibleName(EditorTexts::tr("Words"));
  line->resize(std::min(200, view->width()), line->sizeHint().height());
  line->move(std::clamp(int(place.x()), 0, view->width() - line->width()),
    std::clamp(int(place.y()), 0, std::max(view->height() - line->height(), 0)));
  const auto finish = [line, take](const QString& words)
  {
    line->disconnect(); // the line loses the focus when it is hidden
    line->hide();
    line->deleteLater();
    take(words);
  };
  QObject::connect(
    line, &QLineEdit::editingFinished, line, [line, finish] { finish(line->text().trimmed()); });
  auto* const escape = new QShortcut(Qt::Key_Escape, line, nullptr, nullptr, Qt::WidgetShortcut);
  QObject::connect(escape, &QShortcut::activated, line, [finish] { finish({}); });
  line->show();
  line->setFocus();
}

}
