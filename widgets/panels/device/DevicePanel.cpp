// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/device/DevicePanel.h"

#include "controls/ScrolledPanel.h"
#include "controls/property/PropertyList.h"
#include "haptics/servo/ServoSample.h"
#include "panels/device/DeviceCard.h"
#include "panels/device/DeviceText.h"
#include "panels/device/LivePage.h"
#include "panels/device/MappingForm.h"
#include "panels/device/TimingPage.h"

#include <QLabel>
#include <QLocale>
#include <QScrollArea>
#include <QStyle>
#include <QTabBar>
#include <QTabWidget>
#include <QVBoxLayout>

namespace handwheel {

namespace {

constexpr int kLeastWidth = 296;  // logical pixels: for the titles of the axes

// Creates an area that scrolls a page if the window is low.
QScrollArea* scrolling(QWidget* page) {
  auto* area = new QScrollArea;
  area->setFrameShape(QFrame::NoFrame);
  area->setWidgetResizable(true);
  area->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  area->setFocusPolicy(Qt::NoFocus);  // its parts have it
  area->setWidget(page);
  return area;
}

std::vector<Property> sheetOf(const DeviceInUse& view, const QLocale& locale) {
  std::vector<Property> properties;
  if (!view.chosen) return properties;
  for (const DeviceText::Line& line : DeviceText::dataSheet(view.capabilities, locale)) {
    Property property;
    property.id = property.label = line.name.toStdString();
    property.value = line.value.toStdString();
    property.editable = property.translated = false;
    properties.push_back(std::move(property));
  }
  return properties;
}

}  // namespace

DevicePanel::DevicePanel(QWidget* parent)
    : QWidget(parent),
      m_card(new DeviceCard(this)),
      m_pages(new QTabWidget(this)),
      m_live(new LivePage),
      m_mapping(new MappingForm),
      m_timing(new TimingPage),
      m_dataSheet(new PropertyList),
      m_safety(new QLabel(this)) {
  setObjectName(QStringLiteral("devicePanel"));
  setMinimumWidth(kLeastWidth);
  addPages();
  m_dataSheet->setEmptyText(tr("No device is in use."));
  m_dataSheet->setProperties({});
  m_safety->setObjectName(QStringLiteral("safetyText"));
  m_safety->setWordWrap(true);
  m_safety->setContentsMargins(12, 4, 12, 8);
  m_safety->setAlignment(Qt::AlignLeft | Qt::AlignTop);
  // Two lines are always reserved: a changing text would move the rest to and fro.
  m_safety->setMinimumHeight(2 * m_safety->fontMetrics().lineSpacing() + 12);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(8);
  column->addWidget(m_card);
  column->addWidget(m_pages, 1);
  column->addWidget(m_safety);
  connectParts();
}

void DevicePanel::addPages() {
  m_pages->setObjectName(QStringLiteral("devicePages"));
  m_pages->setDocumentMode(true);
  m_pages->tabBar()->setObjectName(QStringLiteral("panelPages"));
  m_pages->tabBar()->setDrawBase(false);
  m_pages->tabBar()->setAccessibleName(tr("About the device"));
  m_pages->addTab(scrolling(m_live), tr("Live"));
  m_pages->addTab(new ScrolledPanel(m_mapping, ScrolledPanel::Directions::Vertical), tr("Mapping"));
  m_pages->addTab(scrolling(m_timing), tr("Timing"));
  m_pages->addTab(m_dataSheet, tr("Data"));
}

void DevicePanel::addPage(QWidget* page, const QString& title) {
  m_pages->addTab(new ScrolledPanel(page, ScrolledPanel::Directions::Vertical), title);
}

void DevicePanel::showPage(QWidget* page) {
  for (int i = 0; i < m_pages->count(); ++i) {
    if (m_pages->widget(i)->isAncestorOf(page)) m_pages->setCurrentIndex(i);
  }
}

void DevicePanel::connectParts() {
  connect(m_card, &DeviceCard::deviceChosen, this, &DevicePanel::deviceChosen);
  connect(m_card, &DeviceCard::deviceLeft, this, &DevicePanel::deviceLeft);
  connect(m_card, &DeviceCard::rescanRequested, this, &DevicePanel::rescanRequested);
  connect(m_card, &DeviceCard::realTimeAdviceRequested, this, [this] { m_pages->setCurrentIndex(2); });
  connect(m_live, &LivePage::forceOnChanged, this, &DevicePanel::forceOnChanged);
  connect(m_live, &LivePage::forceTestRequested, this, &DevicePanel::forceTestRequested);
  connect(m_live, &LivePage::handLed, this, &DevicePanel::handLed);
  connect(m_mapping, &MappingForm::mappingChanged, this, &DevicePanel::mappingChanged);
}

void DevicePanel::showDevice(const DeviceInUse& view) {
  const auto key = [](const DeviceInfo& listing) { return listing.driver + '\n' + listing.address; };
  const bool isSame = view.chosen.has_value() == m_view.chosen.has_value() &&
                      (!view.chosen || key(*view.chosen) == key(*m_view.chosen));
  m_view = view;
  m_card->showDevice(view);
  m_live->showDevice(view);
  m_mapping->setDevice(view.capabilities);
  m_mapping->setEnabled(view.chosen.has_value());  // a mapping belongs to a device
  m_dataSheet->setProperties(sheetOf(view, locale()));
  if (isSame) return;
  clearLive();
  m_timing->clear();
}

void DevicePanel::setMapping(const WorkspaceMapping& mapping) {
  m_mapping->setMapping(mapping);
}

void DevicePanel::showSample(const ServoSample& sample, double stiffnessAtDevice) {
  if (!isVisible()) return;
  m_card->showStatus(sample.device.status);
  m_live->showSample(sample, m_mapping->mapping().forceGain);
  noteSoftening(sample, stiffnessAtDevice);
  showSafety(m_memory.add(sample.actions, sample.tip.time));
}

void DevicePanel::showHand(const HandPose& hand) {
  m_live->showHand(hand);
}

// Notes the softening for a while, because a touch may be shorter than the time to read the text.
void DevicePanel::noteSoftening(const ServoSample& sample, double stiffnessAtDevice) {
  const ForceOut& felt = sample.felt;
  const double age = sample.tip.time - m_softenedAt;
  if (felt.stiffness < felt.asked) {
    const double rate = m_rate > 0.0 ? m_rate : m_view.capabilities.nominalRate;
    m_softened = DeviceText::softened(stiffnessAtDevice * felt.stiffness, stiffnessAtDevice * felt.asked, m_view, rate,
                                      locale());
    m_softenedAt = sample.tip.time;
  } else if (!(age >= 0.0 && age < SafetyActionHold::kHold)) {
    m_softened.clear();
  }
}

void DevicePanel::setAxisWords(const QStringList& words) {
  m_live->setAxisWords(words);
}

void DevicePanel::showLoop(const ServoLoopStatus& loop) {
  m_rate = loop.rate;
  m_card->showLoop(loop);
  m_timing->showLoop(loop);
}

void DevicePanel::showTiming(const ServoStatistics& measure) {
  if (m_timing->isVisible()) m_timing->showTiming(measure);
}

// Later values would seem to follow upon those seen last.
void DevicePanel::hideEvent(QHideEvent* event) {
  clearLive();
  QWidget::hideEvent(event);
}

void DevicePanel::clearLive() {
  m_live->clear();
  m_memory.clear();
  m_softened.clear();
  m_safety->clear();
}

void DevicePanel::showSafety(SafetyActions actions) {
  QStringList lines = DeviceText::safety(actions);
  if (!m_softened.isEmpty()) lines.prepend(m_softened);
  const QString text = lines.isEmpty() ? tr("Safety: the force is not limited.") : lines.join(QLatin1Char('\n'));
  if (text == m_safety->text()) return;
  m_safety->setText(text);
  m_safety->setProperty("bad", !actions.isEmpty());
  m_safety->setProperty("muted", actions.isEmpty());
  m_safety->style()->polish(m_safety);  // the style sheet colours errors
}

}  // namespace handwheel
