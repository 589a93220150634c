#include "Viewer/Panels/MeasuresPanel.h"

#include "Viewer/Model/MeasureTexts.h"

#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <QTableWidget>
#include <QVBoxLayout>

namespace varimarch
{

namespace
{

// The rows of the table list the distances, then the angles, then the boxes.
template <class Change>
void ChangeRow(Scene& scene, int row, const Change& change)
{
  const int angle = row - int(scene.distances.size());
  const int box = angle - int(scene.angles.size());
  if (box >= 0)
  {
    change(scene.boxes, box);
  }
  else if (angle >= 0)
  {
    change(scene.angles, angle);
  }
  else
  {
    change(scene.distances, row);
  }
}

}

MeasuresPanel::MeasuresPanel(SceneModel* model, QWidget* parent)
  : QWidget(parent)
  , model(model)
  , table(new QTableWidget(0, 2))
  , remove(new QPushButton(tr("Remove")))
  , removeAll(new QPushButton(tr("Remove all")))
{
  auto* const hint =
    new QLabel(tr("Choose Distance, Angle or Box above, then drag in the volume or in a slice. "
                  "Points can be dragged later; double-click a name to change it."));
  hint->setWordWrap(true);
  this->table->setAccessibleName(tr("Measurements"));
  this->table->setHorizontalHeaderLabels({ tr("Name"), tr("Value") });
  this->table->horizontalHeader()->setStretchLastSection(true);
  this->table->verticalHeader()->hide();
  this->table->verticalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  this->table->setSelectionBehavior(QAbstractItemView::SelectRows);
  this->table->setSelectionMode(QAbstractItemView::SingleSelection);
  auto* const buttons = new QHBoxLayout;
  buttons->addWidget(this->remove);
  buttons->addWidget(this->removeAll);
  auto* const layout = new QVBoxLayout(this);
  layout->addWidget(hint);
  layout->addWidget(this->table, 1);
  layout->addLayout(buttons);
  connect(this->table, &QTableWidget::itemChanged, this, &MeasuresPanel::Rename);
  connect(this->remove, &QPushButton::clicked, this, &MeasuresPanel::RemoveSelected);
  connect(this->removeAll, &QPushButton::clicked, this, &MeasuresPanel::RemoveAll);
  connect(model, &SceneModel::Changed, this, &MeasuresPanel::Show);
  this->setEnabled(false);
}

void MeasuresPanel::Show(ScenePart part)
{
  if (part != ScenePart::Volume && part != ScenePart::Measures)
  {
    return;
  }
  this->setEnabled(true);
  const QSignalBlocker quiet(this->table);
  const int row = this->table->currentRow();
  const Scene& scene = this->model->CurrentScene();
  const MeasureTexts texts(scene, this->model->CurrentStudy()->volume);
  this->table->setRowCount(0);
  for (int i = 0; i < texts.distances.size(); ++i)
  {
    this->AddRow(scene.distances[i].name, tr("Distance"), texts.distances[i]);
  }
  for (int i = 0; i < texts.angles.size(); ++i)
  {
    this->AddRow(scene.angles[i].name, tr("Angle"), texts.angles[i]);
  }
  for (int i = 0; i < texts.boxes.size(); ++i)
  {
    this->AddRow(scene.boxes[i].name, tr("Box"), texts.boxes[i]);
  }
  const int rows = this->table->rowCount();
  this->table->setCurrentCell(row >= 0 && row < rows ? row : rows - 1, 0);
  this->remove->setEnabled(rows > 0);
  this->removeAll->setEnabled(rows > 0);
}

void MeasuresPanel::AddRow(const std::string& name, const QString& kind, const QString& text)
{
  const int row = this->table->rowCount();
  this->table->insertRow(row);
  this->table->setItem(
    row, 0, new QTableWidgetItem(name.empty() ? kind : QString::fromStdString(name)));
  auto* const value = new QTableWidgetItem(text);
  value->setFlags(Qt::ItemIsSelectable | Qt::ItemIsEnabled);
  this->table->setItem(row, 1, value);
}

void MeasuresPanel::Rename(QTableWidgetItem* item)
{
  const int row = item->row();
  const std::string name = item->text().trimmed().toStdString();
  this->model->Edit(ScenePart::Measures, tr("rename"),
    [&](Scene& scene)
    { ChangeRow(scene, row, [&](auto& measures, int i) { measures[i].name = name; }); });
}

void MeasuresPanel::RemoveSelected()
{
  const int row = this->table->currentRow();
  this->model->Edit(ScenePart::Measures, tr("remove a measurement"),
    [&](Scene& scene) {
      ChangeRow(scene, row, [&](auto& measures, int i) { measures.erase(measures.begin() + i); });
    });
}

void MeasuresPanel::RemoveAll()
{
  this->model->Edit(ScenePart::Measures, tr("remove all measurements"),
    [](Scene& scene)
    {
      scene.distances.clear();
      scene.angles.clear();
      scene.boxes.clear();
    });
}

}
