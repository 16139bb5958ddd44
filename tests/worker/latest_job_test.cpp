#include "core/base/latest_job.h"

#include <doctest/doctest.h>

#include <atomic>
#include <chrono>
#include <future>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

using nacre::LatestJob;
using namespace std::chrono_literals;
using Job = LatestJob<int, int>;

void spin_until_stopped(const std::stop_token& stop) {
    while (!stop.stop_requested()) std::this_thread::sleep_for(100us);
}

}  // namespace

TEST_CASE("LatestJob: a result carries the revision of its request") {
    Job job([](int request, const std::stop_token&, const Job::Publish& publish) { publish(request * 2); });
    const auto first = job.submit(21);
    job.wait();
    const auto published = job.poll();
    REQUIRE(published);
    CHECK(published->revision == first);
    CHECK(published->result == 42);
    CHECK(!published->error);
    CHECK(!job.poll());
    CHECK(!job.busy());
    CHECK(job.submit(1) > first);
}

TEST_CASE("LatestJob: tells of each publication and of its end, when both can be seen") {
    std::atomic<int> told = 0, published = 0;
    std::promise<void> idle;
    Job* seen = nullptr;
    Job job(
        [](int request, const std::stop_token&, const Job::Publish& publish) {
            publish(request);
            publish(request + 1);
        },
        [&] {
            ++told;
            if (seen->poll()) ++published;
            if (!seen->busy()) idle.set_value();
        });
    seen = &job;
    job.submit(1);
    idle.get_future().wait();
    CHECK(told == 3);
    CHECK(published == 2);
}

TEST_CASE("LatestJob: an error belongs to who polls it, and the worker keeps no hold of it") {
    struct Failure {
        std::shared_ptr<int> mark;
    };
    std::weak_ptr<int> mark;
    std::promise<bool> gone;
    Job* seen = nullptr;
    Job job(
        [&](int, const std::stop_token&, const Job::Publish&) {
            Failure failure{std::make_shared<int>(0)};
            mark = failure.mark;
            throw failure;
        },
        [&] {
            if (seen->poll()) gone.set_value(mark.expired());
        });
    seen = &job;
    job.submit(1);
    CHECK(gone.get_future().get());
}

TEST_CASE("LatestJob: the newest request replaces a waiting one") {
    std::promise<void> gate;
    const std::shared_future<void> open = gate.get_future().share();
    std::mutex mutex;
    std::vector<int> seen;
    Job job([&](int request, const std::stop_token&, const Job::Publish& publish) {
        open.wait();
        const std::lock_guard lock(mutex);
        seen.push_back(request);
        publish(request);
    });
    job.submit(0);
    std::this_thread::sleep_for(20ms);
    for (int i = 1; i <= 5; ++i) job.submit(i);
    gate.set_value();
    job.wait();
    CHECK(seen == std::vector<int>{0, 5});
    CHECK(job.poll()->result == 5);
}

TEST_CASE("LatestJob: a quick answer is waited for, a slow one is not") {
    std::promise<void> gate;
    const std::shared_future<void> open = gate.get_future().share();
    Job job([&](int request, const std::stop_token&, const Job::Publish& publish) {
        if (request == 2) open.wait();
        publish(request);
    });
    CHECK(!job.poll(1h));  // nothing is asked
    job.submit(1);
    CHECK(job.poll(1h)->result == 1);
    job.submit(2);
    CHECK(!job.poll(5ms));
    gate.set_value();
    CHECK(job.poll(1h)->result == 2);
}

TEST_CASE("LatestJob: a failure ends the wait too") {
    Job job([](int, const std::stop_token&, const Job::Publish&) { throw std::runtime_error("no"); });
    job.submit(1);
    CHECK(job.poll(1h)->error);
}

TEST_CASE("LatestJob: work that has not published is not stopped by a newer request") {
    std::atomic<bool> draft_allowed = false;
    std::atomic<int> started = 0;
    std::atomic<int> drafts = 0;
    Job job([&](int request, const std::stop_token& stop, const Job::Publish& publish) {
        ++started;
        while (!draft_allowed && !stop.stop_requested()) std::this_thread::sleep_for(100us);
        if (stop.stop_requested()) return;
        ++drafts;
        publish(request);
        if (request == 1) spin_until_stopped(stop);
    });
    job.submit(1);
    while (started == 0) std::this_thread::sleep_for(100us);
    job.submit(2);
    std::this_thread::sleep_for(20ms);
    draft_allowed = true;
    job.wait();  // the first is stopped by its own publish, as the second waits
    CHECK(drafts == 2);
    CHECK(job.poll()->result == 2);
}

TEST_CASE("LatestJob: work that has published is stopped at once by a newer request") {
    Job job([](int request, const std::stop_token& stop, const Job::Publish& publish) {
        publish(request);
        if (request == 1) spin_until_stopped(stop);
    });
    job.submit(1);
    while (!job.poll()) std::this_thread::sleep_for(100us);
    const auto start = std::chrono::steady_clock::now();
    job.submit(2);
    job.wait();
    CHECK(std::chrono::steady_clock::now() - start < 1s);
    CHECK(job.poll()->result == 2);
}

TEST_CASE("LatestJob: requests that never pause still get results") {
    Job job([](int request, const std::stop_token& stop, const Job::Publish& publish) {
        std::this_thread::sleep_for(3ms);
        if (stop.stop_requested()) return;
        publish(request);
        for (int i = 0; i < 50 && !stop.stop_requested(); ++i) std::this_thread::sleep_for(1ms);
    });
    int results = 0;
    std::uint64_t last = 0;
    for (int i = 0; i < 300; ++i) {
        job.submit(i);
        std::this_thread::sleep_for(1ms);
        if (const auto published = job.poll()) {
            ++results;
            CHECK(published->revision > last);
            last = published->revision;
        }
    }
    CHECK(results > 20);
}

TEST_CASE("LatestJob: what the work throws reaches the poller, and the worker lives on") {
    Job job([](int request, const std::stop_token&, const Job::Publish& publish) {
        if (request < 0) throw std::runtime_error("negative");
        publish(request);
    });
    const auto revision = job.submit(-1);
    job.wait();
    const auto failed = job.poll();
    REQUIRE(failed);
    CHECK(failed->revision == revision);
    CHECK(!failed->result);
    CHECK_THROWS_WITH(std::rethrow_exception(failed->error), "negative");
    job.submit(7);
    job.wait();
    CHECK(job.poll()->result == 7);
}

TEST_CASE("LatestJob: what a stopped work throws is not reported") {
    Job job([](int request, const std::stop_token& stop, const Job::Publish& publish) {
        publish(request);
        if (request == 1) {
            spin_until_stopped(stop);
            throw std::runtime_error("cancelled");
        }
    });
    job.submit(1);
    while (!job.poll()) std::this_thread::sleep_for(100us);
    job.submit(2);
    job.wait();
    const auto published = job.poll();
    REQUIRE(published);
    CHECK(!published->error);
    CHECK(published->result == 2);
}

TEST_CASE("LatestJob: destruction stops running work promptly, and drops what waits") {
    std::atomic<int> runs = 0;
    const auto start = std::chrono::steady_clock::now();
    {
        Job job([&](int, const std::stop_token& stop, const Job::Publish&) {
            ++runs;
            spin_until_stopped(stop);
        });
        job.submit(1);
        while (runs == 0) std::this_thread::sleep_for(100us);
        job.submit(2);
    }
    CHECK(runs == 1);
    CHECK(std::chrono::steady_clock::now() - start < 1s);
}

TEST_CASE("LatestJob: created and destroyed without or right after a request") {
    for (int i = 0; i < 200; ++i) {
        LatestJob<std::string, std::string> job([](const std::string& request, const std::stop_token&,
                                                   const auto& publish) { publish(request); });
        if (i % 2 != 0) job.submit(std::to_string(i));
    }
}
