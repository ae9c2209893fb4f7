// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "TestClass.h"
#include "base/Service.h"
#include "base/ThreadClock.h"

#include <rapidcheck.h>
#include <QTest>
#include <chrono>
#include <thread>
#include <vector>

using namespace handwheel;

namespace {

// A service that records its starts (+) and stops (-).
struct Recorder {
  std::string calls;
  Service service{"contact", [this] { calls += '+'; }, [this] { calls += '-'; }};
};

// Spins until this thread has used that much CPU time.
void burn(double microseconds) {
  const std::uint64_t start = threadCpuNanoseconds();
  while (static_cast<double>(threadCpuNanoseconds() - start) < microseconds * 1e3) {
  }
}

}  // namespace

class ServiceTest : public QObject {
  Q_OBJECT

 private slots:
  void startsWithTheFirstNeedAndStopsWithTheLast();
  void needBeforeService();
  void needsMove();
  void removedServiceStops();
  void onlyWhatIsNeededTicks();
  void tickCountsCpuTimeOnly();
  void timesOfClockAndProcessor();
  void ticksFromManyThreads();
  void runsExactlyWhileNeeded();
};

void ServiceTest::startsWithTheFirstNeedAndStopsWithTheLast() {
  Recorder r;
  ServiceRegistry needs;
  needs.add(r.service);
  QVERIFY(!r.service.isRunning());
  {
    const ServiceHandle first = needs.need("contact");
    {
      const ServiceHandle second = needs.need("contact");
      QCOMPARE(needs.needCount("contact"), std::size_t{2});
    }
    QVERIFY(r.service.isRunning());
    QCOMPARE(r.calls, std::string("+"));
  }
  QVERIFY(!r.service.isRunning());
  QCOMPARE(r.calls, std::string("+-"));
  { const ServiceHandle again = needs.need("contact"); }
  QCOMPARE(r.calls, std::string("+-+-"));
  QCOMPARE(r.service.counters().starts, std::uint64_t{2});
  QCOMPARE(needs.needCount("contact"), std::size_t{0});
  QCOMPARE(needs.needCount("sound"), std::size_t{0});
}

void ServiceTest::needBeforeService() {
  Recorder r;
  ServiceRegistry needs;
  const ServiceHandle need = needs.need("contact");
  const ServiceHandle other = needs.need("sound");  // nobody offers it, and nothing happens
  QCOMPARE(r.calls, std::string());
  needs.add(r.service);
  QCOMPARE(r.calls, std::string("+"));
  int known = 0;
  needs.forEach([&](const Service& service) {
    QCOMPARE(service.id(), std::string("contact"));
    ++known;
  });
  QCOMPARE(known, 1);
}

void ServiceTest::needsMove() {
  Recorder r;
  ServiceRegistry needs;
  needs.add(r.service);
  std::vector<ServiceHandle> held;
  for (int i = 0; i < 20; ++i) held.push_back(needs.need("contact"));  // the vector moves them as it grows
  QCOMPARE(needs.needCount("contact"), std::size_t{20});
  ServiceHandle one = std::move(held.back());
  held.clear();
  QCOMPARE(needs.needCount("contact"), std::size_t{1});
  one = needs.need("contact");  // the new one comes before the old one goes: no restart
  QCOMPARE(needs.needCount("contact"), std::size_t{1});
  QCOMPARE(r.calls, std::string("+"));
  one = ServiceHandle();
  QCOMPARE(r.calls, std::string("+-"));
}

void ServiceTest::removedServiceStops() {
  Recorder r;
  ServiceRegistry needs;
  needs.add(r.service);
  const ServiceHandle need = needs.need("contact");
  needs.remove(r.service);
  QCOMPARE(r.calls, std::string("+-"));
  QVERIFY(!r.service.isRunning());
  needs.add(r.service);
  QCOMPARE(r.calls, std::string("+-+"));
}

// A scene that declares one need: the counters show that nothing else ever ran.
void ServiceTest::onlyWhatIsNeededTicks() {
  Service contact("contact"), physics("physics");
  ServiceRegistry needs;
  needs.add(contact);
  needs.add(physics);
  const ServiceHandle need = needs.need("contact");
  for (int i = 0; i < 100; ++i) {
    for (Service* service : {&contact, &physics}) {
      if (service->isRunning()) const ServiceTick tick(*service);
    }
  }
  QCOMPARE(contact.counters().ticks, std::uint64_t{100});
  QVERIFY(contact.counters().cpuMicroseconds > 0.0);
  QCOMPARE(physics.counters().ticks, std::uint64_t{0});
  QCOMPARE(physics.counters().starts, std::uint64_t{0});
  QCOMPARE(physics.counters().cpuMicroseconds, 0.0);
}

void ServiceTest::tickCountsCpuTimeOnly() {
  Service busy("busy"), idle("idle");
  {
    const ServiceTick tick(busy);
    burn(2000.0);
  }
  QVERIFY(busy.counters().cpuMicroseconds >= 2000.0);
  {
    const ServiceTick tick(idle);
    std::this_thread::sleep_for(std::chrono::milliseconds(30));
  }
  QVERIFY(idle.counters().cpuMicroseconds < 15'000.0);  // half of what the clock on the wall shows at least
  QVERIFY(cpuMilliseconds([] { burn(500.0); }) >= 0.5);
}

// The clock goes on in a sleep of 5 ms, the CPU time need not.
void ServiceTest::timesOfClockAndProcessor() {
  const CpuTimes before = CpuTimes::now();
  burn(1000.0);
  std::this_thread::sleep_for(std::chrono::milliseconds(5));
  const CpuTimes used = CpuTimes::now() - before;
  QVERIFY(used.cpu >= 1.0 && used.cpu < used.clock);
  const CpuTimes twice = used + used;
  QVERIFY(twice.cpu == 2.0 * used.cpu && twice.clock == 2.0 * used.clock);
}

void ServiceTest::ticksFromManyThreads() {
  Service service("contact");
  std::vector<std::thread> threads;
  for (int i = 0; i < 4; ++i) {
    threads.emplace_back([&] {
      for (int k = 0; k < 5000; ++k) const ServiceTick tick(service);
    });
  }
  for (std::thread& t : threads) t.join();
  QCOMPARE(service.counters().ticks, std::uint64_t{20'000});
}

// For any sequence of needs, a service runs exactly while somebody needs it.
void ServiceTest::runsExactlyWhileNeeded() {
  QVERIFY(rc::check("a service runs exactly while it is needed", [] {
    Service services[] = {Service("a"), Service("b"), Service("c")};
    ServiceRegistry needs;
    for (Service& s : services) needs.add(s);
    std::vector<std::pair<std::size_t, ServiceHandle>> held;
    std::size_t count[3] = {};
    const auto steps = *rc::gen::container<std::vector<int>>(rc::gen::inRange(0, 6));
    for (int step : steps) {
      const auto which = static_cast<std::size_t>(step % 3);
      if (step < 3) {
        held.emplace_back(which, needs.need(services[which].id()));
        ++count[which];
      } else if (!held.empty()) {
        const std::size_t victim = which % held.size();
        --count[held[victim].first];
        held.erase(held.begin() + static_cast<std::ptrdiff_t>(victim));
      }
      for (std::size_t i = 0; i < 3; ++i) {
        RC_ASSERT(services[i].isRunning() == (count[i] > 0));
        RC_ASSERT(needs.needCount(services[i].id()) == count[i]);
      }
    }
  }));
}

HANDWHEEL_TEST(ServiceTest)
#include "ServiceTest.moc"
