#include "Viewer/AccessibleNames.h"

#include <QAbstractButton>
#include <QLabel>
#include <QWidget>

namespace varimarch
{

namespace
{

void NameParts(const QWidget* whole, const QString& name)
{
  for (QWidget* const part : whole->findChildren<QWidget*>())
  {
    const bool isControl =
      (part->focusPolicy() & Qt::TabFocus) && !qobject_cast<QAbstractButton*>(part);
    if (isControl && part->accessibleName().isEmpty())
    {
      part->setAccessibleName(name);
    }
  }
}

}

void NamePartsOfControls(QWidget* window)
{
  for (const QLabel* const label : window->findChildren<QLabel*>())
  {
    if (label->buddy() && label->buddy()->accessibleName().isEmpty())
    {
      NameParts(label->buddy(), label->text().remove('&'));
    }
  }
  for (const QWidget* const whole : window->findChildren<QWidget*>())
  {
    if (!whole->accessibleName().isEmpty() && !(whole->focusPolicy() & Qt::TabFocus))
    {
      NameParts(whole, whole->accessibleName());
    }
  }
}

}
