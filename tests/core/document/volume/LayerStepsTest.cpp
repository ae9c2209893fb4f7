// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/volume/LayerSteps.h"

#include "TestClass.h"
#include "document/volume/VolumeDocument.h"
#include "document/volume/VolumeKind.h"
#include "volume/VolumeDifference.h"
#include "volume/VolumeShapes.h"
#include "volume/clay/ClayDab.h"

#include <QtTest>
#include <cmath>
#include <functional>
#include <limits>
#include <nlohmann/json.hpp>
#include <random>

using namespace handwheel;
using nlohmann::json;

namespace {

constexpr double kBall = 4.0, kFine = 0.25;  // mm

std::unique_ptr<VolumeDocument> ballDocument(const VolumeKind& kind) {
  auto content = std::make_shared<VolumeSnapshot>();
  content->volume = ballOfVoxels(kBall, kFine);
  content->surface = VolumeSurface(content->volume);
  return std::make_unique<VolumeDocument>(OpenedFile{&kind, {}, std::move(content)});
}

// Applies a stroke like the clay tool.
void strokeOn(VolumeDocument& document, ClayAction action, const Vec3& centre, double radius) {
  auto after = std::make_shared<VolumeSnapshot>(*document.volume());
  ClayDab dab;
  dab.action = action;
  dab.centre = centre;
  dab.radius = radius;
  const std::vector<VoxelIndex> changed = applyDab(after->volume, dab);
  after->surface.update(after->volume, changed);
  recordStroke(*document.volume(), *after);
  document.commit("stroke", std::make_unique<VolumeEdit>(std::move(after), changed.size()));
}

bool sameVolume(const SparseVolume& a, const SparseVolume& b) {
  return differingBlocks(a, b).empty() && a.material() == b.material();
}

bool sameLayers(const VolumeSnapshot& a, const VolumeSnapshot& b) {
  if (!sameVolume(a.volume, b.volume) || !a.layers != !b.layers) return false;
  if (!a.layers) return true;
  if (!sameVolume(a.layers->root(), b.layers->root()) || a.layers->all().size() != b.layers->all().size()) return false;
  for (std::size_t i = 0; i < a.layers->all().size(); ++i) {
    const ClayLayer &one = a.layers->all()[i], &other = b.layers->all()[i];
    if (one.name != other.name || one.strength != other.strength || one.isOn != other.isOn) return false;
    if (one.change->blocks() != other.change->blocks()) return false;
    for (const VoxelIndex& block : one.change->blocks())
      if (!isSameContent(one.change->base().view(block), other.change->base().view(block)) ||
          !isSameContent(one.change->top().view(block), other.change->top().view(block)))
        return false;
  }
  return true;
}

// A random step of a sculptor.
void randomStep(VolumeDocument& document, std::mt19937& random) {
  const auto below = [&](double most) { return std::uniform_real_distribution(0.0, most)(random); };
  const VolumeSnapshot& now = *document.volume();
  const std::size_t count = now.layers ? now.layers->all().size() : 0;
  const std::size_t layer = count > 0 ? random() % count : 0;
  const unsigned what = random() % 8;
  if (count == 0 || (what == 0 && count < 4)) {
    document.commit("add", withNewLayer(now, "layer " + std::to_string(random() % 100)).edit());
  } else if (what == 1) {
    document.commit("remove", withoutLayer(now, layer).edit());
  } else if (what == 2) {
    document.commit("merge", withLayerMerged(now, layer).edit());
  } else if (what < 5) {
    const double strength = random() % 3 == 0 ? 1.0 : below(1.0);
    document.commit("share", withLayerShare(now, layer, strength, random() % 4 != 0).edit());
  } else if (takesStrokes(now)) {
    const Vec3 centre = kBall * Vec3(below(2.0) - 1.0, below(2.0) - 1.0, below(2.0) - 1.0);
    strokeOn(document, random() % 2 == 0 ? ClayAction::Add : ClayAction::Carve, centre, 0.5 + below(1.5));
  } else {
    document.commit("share", withLayerShare(now, count - 1, 1.0, true).edit());
  }
}

std::shared_ptr<const VolumeSnapshot> savedAndLoaded(const VolumeKind& kind, const VolumeSnapshot& value,
                                                     std::vector<Error>& damage,
                                                     const std::function<void(Container&)>& change = {}) {
  Container container;
  kind.save(value, container);
  if (change) change(container);
  const auto loaded = kind.load(container, damage, {});
  return loaded ? std::static_pointer_cast<const VolumeSnapshot>(*loaded) : nullptr;
}

}  // namespace

class LayerStepsTest : public QObject {
  Q_OBJECT

 private slots:
  // For any sequence of steps, the volume is the result of its layers, undo and redo restore each state, and files keep
  // it.
  void undoRedoAndFiles() {
    const VolumeKind kind;
    for (unsigned seed = 1; seed <= 12; ++seed) {
      const auto document = ballDocument(kind);
      std::mt19937 random(seed);
      std::vector<std::shared_ptr<const VolumeSnapshot>> states;
      const auto keep = [&] {
        // A copy of its own of what is compared: the history exchanges the values.
        states.push_back(std::make_shared<const VolumeSnapshot>(*document->volume()));
      };
      keep();
      for (int i = 0; i < 14; ++i) {
        randomStep(*document, random);
        const VolumeSnapshot& now = *document->volume();
        if (now.layers) QVERIFY(sameVolume(now.layers->visible(), now.volume));
        keep();
      }
      QCOMPARE(document->history()->count(), 14);
      for (std::size_t i = states.size() - 1; i > 0; --i) {
        QVERIFY(sameLayers(*document->volume(), *states[i]));
        document->history()->undo();
      }
      QVERIFY(sameLayers(*document->volume(), *states.front()));
      for (std::size_t i = 1; i < states.size(); ++i) {
        document->history()->redo();
        QVERIFY(sameLayers(*document->volume(), *states[i]));
      }
      std::vector<Error> damage;
      const auto loaded = savedAndLoaded(kind, *document->volume(), damage);
      QVERIFY(loaded && damage.empty());
      QVERIFY(sameLayers(*loaded, *document->volume()));
      if (!loaded->layers) continue;
      // The file also determines later changes of the layers.
      for (std::size_t i = 0; i < loaded->layers->all().size(); ++i)
        QVERIFY(sameVolume(withLayerShare(*loaded, i, 0.4, true).volume->volume,
                           withLayerShare(*document->volume(), i, 0.4, true).volume->volume));
    }
  }

  // A drag of the strength is one step, and none where it ends as it began; other properties are steps of their own.
  void properties() {
    const VolumeKind kind;
    const auto document = ballDocument(kind);
    const double ball = document->volume()->volume.material();
    document->commit("add", withNewLayer(*document->volume(), "nose").edit());
    strokeOn(*document, ClayAction::Add, Vec3(0, 0, kBall), 1.5);
    const double full = document->volume()->volume.material();
    QVERIFY(full > ball);
    for (const double strength : {0.8, 0.5, 0.3})
      QVERIFY(document->setProperty("layer.1.strength", strength, DragPhase::Continues));
    QVERIFY(document->setProperty("layer.1.strength", 0.3, DragPhase::Ends));
    QCOMPARE(document->history()->count(), 3);
    const double weak = document->volume()->volume.material();
    QVERIFY(weak > ball && weak < full);
    document->history()->undo();
    QCOMPARE(document->volume()->volume.material(), full);
    document->history()->redo();
    QCOMPARE(document->volume()->volume.material(), weak);
    QVERIFY(document->setProperty("layer.1.on", false));
    QCOMPARE(document->volume()->volume.material(), ball);
    QVERIFY(document->setProperty("layer.1.name", std::string("Nase")));
    QCOMPARE(document->volume()->layers->all()[0].name, std::string("Nase"));
    QCOMPARE(document->history()->count(), 5);
    document->history()->undo();
    QCOMPARE(document->volume()->layers->all()[0].name, std::string("nose"));
  }

  // A share that was computed ahead is the one that the property sets; one of another volume or share is not.
  void prepared() {
    const VolumeKind kind;
    const auto document = ballDocument(kind);
    document->commit("add", withNewLayer(*document->volume(), "nose").edit());
    strokeOn(*document, ClayAction::Add, Vec3(0, 0, kBall), 1.5);
    const auto share = std::make_shared<const PreparedShare>(prepareShare(document->volume(), 0, 0.5, true));
    document->prepare(share);
    QVERIFY(document->setProperty("layer.1.strength", 0.25));
    QVERIFY(document->volume() != share->step.volume);
    QVERIFY(document->setProperty("layer.1.strength", 0.5));
    QVERIFY(document->volume() != share->step.volume);
    QVERIFY(sameLayers(*document->volume(), *share->step.volume));
    document->history()->undo();
    document->history()->undo();
    QVERIFY(document->setProperty("layer.1.strength", 0.5));
    QCOMPARE(document->volume(), share->step.volume);
    document->prepare(nullptr);
    document->history()->undo();
    QCOMPARE(document->volume(), share->of);
  }

  // Invalid values and layers change nothing and are reported.
  void refused() {
    const VolumeKind kind;
    const auto document = ballDocument(kind);
    QVERIFY(!document->setProperty("layer.1.strength", 0.5));
    document->commit("add", withNewLayer(*document->volume(), "a").edit());
    const auto before = document->volume();
    for (const double strength : {std::nan(""), std::numeric_limits<double>::infinity(), -0.1, 1.1}) {
      const Status set = document->setProperty("layer.1.strength", strength);
      QVERIFY(!set);
      QVERIFY(set.error().code == ErrorCode::ValueOutOfRange);
    }
    const std::string broken = "\xff", endless(1001, 'a');
    for (const auto& [id, value] :
         std::vector<std::pair<std::string, PropertyValue>>{{"layer.1.strength", true},
                                                            {"layer.1.on", 1.0},
                                                            {"layer.1.name", 1.0},
                                                            {"layer.1.name", broken},
                                                            {"layer.1.name", endless},
                                                            {"layer.0.on", false},
                                                            {"layer.2.on", false},
                                                            {"layer.01.on", false},
                                                            {"layer.1.onion", false},
                                                            {"layer.99999999999999999999.on", false}})
      QVERIFY2(!document->setProperty(id, value), id.c_str());
    QCOMPARE(document->volume(), before);
    QCOMPARE(document->history()->count(), 1);
  }

  // Files that nobody has written so: the volume is what it was, the layers are left out, and that is said.
  void hostileFiles() {
    const VolumeKind kind;
    const auto document = ballDocument(kind);
    document->commit("add", withNewLayer(*document->volume(), "a").edit());
    strokeOn(*document, ClayAction::Carve, Vec3(0, 0, kBall), 1.5);
    const VolumeSnapshot& value = *document->volume();
    const auto stack = [](Container& container) -> json& {
      return (*container.manifest)["document"]["layers"]["stack"];
    };
    const std::vector<std::function<void(Container&)>> changes = {
        [&](Container& c) { stack(c)[0]["strength"] = 2.0; },
        [&](Container& c) { stack(c)[0]["strength"] = "1"; },
        [&](Container& c) { stack(c)[0]["strength"] = nullptr; },
        [&](Container& c) { stack(c)[0]["on"] = 1; },
        [&](Container& c) { stack(c)[0]["name"] = json::array(); },
        [&](Container& c) { stack(c)[0]["name"] = std::string(2000, 'a'); },
        [&](Container& c) { stack(c)[0]["top_chunks"] = 90000; },
        [&](Container& c) { stack(c)[0]["base_chunks"] = -1; },
        [&](Container& c) { stack(c)[0] = 3; },
        [&](Container& c) { stack(c) = json::array(); },
        [&](Container& c) { stack(c) = json(std::vector<int>(300, 1)); },
        [&](Container& c) { stack(c) = "layers"; },
        [&](Container& c) { (*c.manifest)["document"]["layers"] = 1; },
        [&](Container& c) { (*c.manifest)["document"]["layers"]["voxel"] = 1.0; },
        [&](Container& c) { (*c.manifest)["document"]["layers"]["visible"] = "0"; },
        [&](Container& c) { (*c.manifest)["document"]["layers"]["root_chunks"] = 1e9; },
        [](Container& c) { c.blobs.erase("document/layers/0/top/0000"); },
        [](Container& c) { c.blobs.at("document/layers/0/base/0000").resize(100); },
        [](Container& c) { c.blobs.at("document/layers/root/0000") = "nonsense"; },
    };
    for (std::size_t i = 0; i < changes.size(); ++i) {
      std::vector<Error> damage;
      const auto loaded = savedAndLoaded(kind, value, damage, changes[i]);
      const QByteArray which = QByteArray::number(static_cast<qulonglong>(i));
      QVERIFY2(loaded && !loaded->layers && !damage.empty(), which);
      QVERIFY2(sameVolume(loaded->volume, value.volume), which);
    }
    std::vector<Error> damage;
    const auto without =
        savedAndLoaded(kind, value, damage, [](Container& c) { (*c.manifest)["document"].erase("layers"); });
    QVERIFY(without && !without->layers && damage.empty());
  }
};

HANDWHEEL_TEST(LayerStepsTest)
#include "LayerStepsTest.moc"
