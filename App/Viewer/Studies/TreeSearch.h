#ifndef Varimarch_Viewer_TreeSearch_h
#define Varimarch_Viewer_TreeSearch_h

#include <QString>

class QTreeWidget;
class QTreeWidgetItem;

namespace varimarch
{

/// The texts of an item's columns, between tabs.
QString LineOf(const QTreeWidgetItem& item);

/// Shows the items that have all the words, on their own or together with the items that they lie
/// below; and the items above those. The others are hidden.
void ShowMatching(QTreeWidget* tree, const QString& words);

}

#endif
