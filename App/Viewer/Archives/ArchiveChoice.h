#ifndef Varimarch_Viewer_ArchiveChoice_h
#define Varimarch_Viewer_ArchiveChoice_h

#include "Viewer/Archives/ArchiveList.h"

#include <QWidget>

#include <optional>

class QComboBox;
class QPushButton;

namespace varimarch
{

/// A box to choose one of the archives that are set up, with buttons to set up more.
class ArchiveChoice : public QWidget
{
  Q_OBJECT

public:
  explicit ArchiveChoice(QWidget* parent = nullptr);

  /// The chosen archive; nothing if none is set up.
  std::optional<NamedArchive> Chosen() const;

signals:
  void Changed();

private:
  void List(int chosen);
  void KeepChoice();
  void Add();
  void Edit();
  void Remove();
  /// Lets the user edit an archive, and keeps it in this row of the list.
  void EditRow(int row, const NamedArchive& archive);

  QVector<NamedArchive> archives;
  QComboBox* box;
  QPushButton* edit;
  QPushButton* remove;
};

}

#endif
