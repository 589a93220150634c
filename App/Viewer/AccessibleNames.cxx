#include "Viewer/AccessibleNames.h"

#include <QAbstractButton>
#include <QAccessible>
#include <QAccessibleWidget>
#include <QAction>
#include <QComboBox>
#include <QLabel>
#include <QToolButton>
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

// A widget that is none of Qt's controls. If it takes keys, it draws itself. Qt asks for this
// before the widget is complete, so the role is not decided then.
class PlainWidget : public QAccessibleWidget
{
public:
  using QAccessibleWidget::QAccessibleWidget;

  QAccessible::Role role() const override
  {
    const bool isCanvas =
      !this->widget()->isWindow() && this->widget()->focusPolicy() & Qt::TabFocus;
    return isCanvas ? QAccessible::Canvas : QAccessibleWidget::role();
  }
};

// Qt asks for each class of a widget in turn, from the most special one on, until somebody answers.
// It has answers for all its own controls.
QAccessibleInterface* NewPlainWidget(const QString& className, QObject* object)
{
  auto* const widget = className == "QWidget" ? qobject_cast<QWidget*>(object) : nullptr;
  return widget ? new PlainWidget(widget) : nullptr;
}

// A screen reader toggles the button of an action, of which Qt does not tell the action.
void ConnectTogglesWithActions(const QWidget* window)
{
  for (QToolButton* const button : window->findChildren<QToolButton*>())
  {
    QAction* const action = button->defaultAction();
    if (action && action->isCheckable())
    {
      QObject::connect(button, &QToolButton::toggled, action,
        [button, action](bool isOn)
        {
          if (isOn != action->isChecked())
          {
            action->trigger();
            button->setChecked(action->isChecked()); // one of a group stays on
          }
        });
    }
  }
}

// The name of a list to choose from is its choice, where it has no label of its own.
void DescribeChoices(const QWidget* window)
{
  for (QComboBox* const choice : window->findChildren<QComboBox*>())
  {
    if (choice->accessibleDescription().isEmpty())
    {
      choice->setAccessibleDescription(choice->accessibleName());
    }
  }
}

}

void TellRolesOfViews()
{
  QAccessible::installFactory(NewPlainWidget);
}

void NamePartsOfControls(QWidget* window)
{
  DescribeChoices(window);
  ConnectTogglesWithActions(window);
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
