#include "Viewer/Studies/StudyTree.h"

#include <QDate>
#include <QLocale>
#include <QRegularExpression>
#include <QStringList>
#include <QTreeWidget>

#include <algorithm>

namespace varimarch
{

namespace
{

// Returns whether the item is shown.
bool ShowIfMatching(QTreeWidgetItem* item, const QString& above, const QStringList& words)
{
  const QString text = above + '\t' + LineOf(*item);
  bool isShown = std::all_of(words.begin(), words.end(),
    [&](const QString& word) { return text.contains(word, Qt::CaseInsensitive); });
  for (int i = 0; i < item->childCount(); ++i)
  {
    isShown = ShowIfMatching(item->child(i), text, words) || isShown;
  }
  item->setHidden(!isShown);
  return isShown;
}

}

QString PersonText(const QString& stored)
{
  // The forms of a name in several alphabets, of which the first may be empty.
  const QStringList forms = stored.split('=', Qt::SkipEmptyParts);
  QStringList parts = forms.isEmpty() ? QStringList() : forms.first().split('^');
  if (parts.isEmpty())
  {
    return {};
  }
  const QString family = parts.takeFirst();
  const QString given = parts.join(' ').simplified();
  return given.isEmpty() ? family : family + ", " + given;
}

QString DateText(const QString& stored)
{
  const QDate date = QDate::fromString(stored, "yyyyMMdd");
  return date.isValid() ? QLocale().toString(date, QLocale::ShortFormat) : stored;
}

QString LineOf(const QTreeWidgetItem& item)
{
  QStringList columns;
  for (int column = 0; column < item.treeWidget()->columnCount(); ++column)
  {
    columns.append(item.text(column));
  }
  return columns.join('\t');
}

void ShowMatching(QTreeWidget* tree, const QString& words)
{
  const QStringList list = words.split(QRegularExpression("\\s+"), Qt::SkipEmptyParts);
  for (int i = 0; i < tree->topLevelItemCount(); ++i)
  {
    ShowIfMatching(tree->topLevelItem(i), {}, list);
  }
}

}
