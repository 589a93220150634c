#ifndef Varimarch_Viewer_StudyTree_h
#define Varimarch_Viewer_StudyTree_h

#include <QString>

class QTreeWidget;
class QTreeWidgetItem;

namespace varimarch
{

/// A person's name as people write it: "Doe, Jane" for "Doe^Jane" (PS3.5 6.2.1.1).
QString PersonText(const QString& stored);

/// A date in the form of the user's language for DICOM's "20261126"; other texts stay.
QString DateText(const QString& stored);

/// The texts of an item's columns, between tabs.
QString LineOf(const QTreeWidgetItem& item);

/// Shows the items that have all the words, on their own or together with the items that they lie
/// below; and the items above those. The others are hidden.
void ShowMatching(QTreeWidget* tree, const QString& words);

}

#endif
