// A report as a Chrome trace, for Perfetto and chrome://tracing.
#include <fmt/format.h>
#include <json/writer.h>

#include <algorithm>
#include <cmath>

#include "timings/report.h"

namespace nephrite::timings {
namespace {

using Nanoseconds = std::int64_t;

enum class Lane { Cpu = 1, Gpu = 2 };

Nanoseconds nanoseconds(double milliseconds) {
    return static_cast<Nanoseconds>(std::llround(std::max(milliseconds, 0.0) * 1e6));
}

/// Microseconds, as the format wants them, and a tenth of a nanosecond: readers that cut off what is below a
/// nanosecond then find the one meant, and no slice sticks out of the one around it.
double microseconds(Nanoseconds time) {
    return static_cast<double>(time) / 1000 + 0.0001;
}

Json::Value event(const char* phase, const std::string& name, const char* category, Lane lane) {
    Json::Value value;
    value["ph"] = phase;
    value["name"] = name;
    if (*category != '\0') value["cat"] = category;
    value["pid"] = 1;
    value["tid"] = static_cast<int>(lane);
    return value;
}

Json::Value named(const char* what, Lane lane, const std::string& name) {
    Json::Value value = event("M", what, "", lane);
    value["args"]["name"] = name;
    return value;
}

Json::Value countsAsArguments(const gpu::PipelineCounts& counts) {
    Json::Value arguments;
    arguments["vertexInvocations"] = static_cast<Json::UInt64>(counts.vertexInvocations);
    arguments["clippingInvocations"] = static_cast<Json::UInt64>(counts.clippingInvocations);
    arguments["fragmentInvocations"] = static_cast<Json::UInt64>(counts.fragmentInvocations);
    arguments["computeInvocations"] = static_cast<Json::UInt64>(counts.computeInvocations);
    return arguments;
}

/// The events of a report. Boundaries are whole nanoseconds, so that slices nest exactly.
class Trace {
  public:
    explicit Trace(const Report& report) : report_(report) {
        if (!report.frames.empty()) origin_ = report.frames.front().times.start;
        for (const Mark& mark : report.marks) origin_ = std::min(origin_, mark.time);
    }

    std::string text() {
        addNames();
        addPlanSkips();
        for (std::size_t i = 0; i < report_.frames.size(); ++i) addFrame(i);
        for (const Mark& mark : report_.marks) addMark(mark);
        Json::Value about;
        about["device"] = report_.device;
        about["driver"] = report_.driver;
        about["commit"] = report_.commit;
        about["profiled"] = report_.profiled;
        return "{\"displayTimeUnit\":\"ms\",\n\"otherData\":" + compact(about) + ",\n\"traceEvents\":[\n" +
               events_ + "\n]}\n";
    }

  private:
    static std::string compact(const Json::Value& value) {
        Json::StreamWriterBuilder builder;
        builder["indentation"] = "";
        builder["precision"] = 17;
        return Json::writeString(builder, value);
    }

    void add(const Json::Value& value) {
        if (!events_.empty()) events_ += ",\n";
        events_ += compact(value);
    }

    Nanoseconds sinceOrigin(std::chrono::steady_clock::time_point time) const {
        return std::chrono::duration_cast<std::chrono::nanoseconds>(time - origin_).count();
    }

    void addNames() {
        add(named("process_name", Lane::Cpu,
                  fmt::format("{}, {}, {} x {}, {}", report_.graph, report_.scene, report_.width,
                              report_.height, report_.device)));
        add(named("thread_name", Lane::Cpu, "CPU"));
        add(named("thread_name", Lane::Gpu, "GPU"));
        for (const Lane lane : {Lane::Cpu, Lane::Gpu}) {
            Json::Value order = event("M", "thread_sort_index", "", lane);
            order["args"]["sort_index"] = static_cast<int>(lane);
            add(order);
        }
    }

    void addSlice(const std::string& name, const char* category, Lane lane, Nanoseconds begin,
                  Nanoseconds end, const Json::Value& arguments = {}) {
        Json::Value value = event("X", name, category, lane);
        value["ts"] = microseconds(begin);
        value["dur"] = microseconds(end - begin);
        if (!arguments.isNull()) value["args"] = arguments;
        add(value);
    }

    void addInstant(const std::string& name, const char* category, Lane lane, Nanoseconds time,
                    const char* scope, const std::string& why) {
        Json::Value value = event("i", name, category, lane);
        value["ts"] = microseconds(time);
        value["s"] = scope;
        value["args"]["why"] = why;
        add(value);
    }

    void addPlanSkips() {
        const Nanoseconds start =
            report_.frames.empty() ? 0 : sinceOrigin(report_.frames.front().times.start);
        for (const SkippedNode& node : report_.skipped)
            addInstant("skipped " + node.name, "skip", Lane::Gpu, start, "t", node.why);
    }

    void addMark(const Mark& mark) {
        addInstant(mark.name, "mark", Lane::Cpu, sinceOrigin(mark.time), "g", mark.detail);
    }

    /// Recording, then waiting around the GPU's part, which has a lane of its own: the clocks of the two are
    /// not related, so it is drawn in the middle of the waiting.
    void addFrame(std::size_t index) {
        const runtime::FrameTimes& times = report_.frames[index].times;
        const std::string name = fmt::format("frame {}", index);
        const Nanoseconds begin = std::max(sinceOrigin(times.start), lastEnd_);
        const Nanoseconds recorded = begin + nanoseconds(times.recordMs);
        const Nanoseconds gpuBegin = recorded + nanoseconds(times.waitMs / 2);
        Nanoseconds gpuEnd = gpuBegin;
        for (const runtime::PassTime& pass : times.passes) gpuEnd += nanoseconds(pass.gpuMs);
        const Nanoseconds end = std::max(begin + nanoseconds(times.wallMs), gpuEnd);
        // What stands around others ends a nanosecond later, so that equal ends cannot be read in a wrong
        // order.
        addSlice(name, "frame", Lane::Cpu, begin, end + 1);
        addSlice("recording", "recording", Lane::Cpu, begin, recorded);
        addRecordings(index, begin, recorded);
        addSlice("waiting", "waiting", Lane::Cpu, recorded, gpuBegin);
        addSlice("waiting", "waiting", Lane::Cpu, gpuEnd, end);
        addSlice(name, "frame", Lane::Gpu, gpuBegin, gpuEnd + 1);
        addPasses(index, gpuBegin);
        lastEnd_ = end + 1;
    }

    template<class Visit>
    void forEachPass(std::size_t index, Visit visit) const {
        const Frame& frame = report_.frames[index];
        const std::vector<std::uint32_t>& passes = report_.plans[frame.plan];
        for (std::size_t i = 0; i < passes.size(); ++i)
            visit(report_.passes[passes[i]], frame.times.passes[i]);
    }

    void addRecordings(std::size_t index, Nanoseconds begin, Nanoseconds limit) {
        Nanoseconds from = begin;
        forEachPass(index, [&](const std::string& name, const runtime::PassTime& pass) {
            if (!pass.ran) return;
            from = std::clamp(begin + nanoseconds(pass.cpuStartMs), from, limit);
            const Nanoseconds to = std::min(from + nanoseconds(pass.cpuMs), limit);
            addSlice(name, "recording", Lane::Cpu, from, to);
            from = to;
        });
    }

    void addPasses(std::size_t index, Nanoseconds begin) {
        Nanoseconds from = begin;
        forEachPass(index, [&](const std::string& name, const runtime::PassTime& pass) {
            if (!pass.ran)
                return addInstant("kept " + name, "skip", Lane::Gpu, from, "t",
                                  "nothing that it reads has changed");
            const Nanoseconds to = from + nanoseconds(pass.gpuMs);
            addSlice(name, "pass", Lane::Gpu, from, to,
                     pass.counts ? countsAsArguments(*pass.counts) : Json::Value());
            from = to;
        });
    }

    const Report& report_;
    std::chrono::steady_clock::time_point origin_;
    Nanoseconds lastEnd_ = 0;
    std::string events_;
};

}  // namespace

std::string asTrace(const Report& report) {
    return Trace(report).text();
}

}  // namespace nephrite::timings
