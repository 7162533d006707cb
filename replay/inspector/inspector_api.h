// The inspector's addresses as a function: a request's path and query in, status and JSON out. Knows no server.
#pragma once

#include <atomic>
#include <functional>
#include <list>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "continua/replay/inspector/run_dropped.h"
#include "continua/replay/inspector/run_library.h"
#include "continua/replay/inspector/run_listings.h"
#include "continua/replay/inspector/run_temporary.h"
#include "continua/replay/inspector/run_what_if.h"
#include "continua/replay/log/run_index.h"
#include "continua/replay/media/run_media.h"
#include "continua/replay/scene/run_frames.h"
#include "continua/replay/scene/run_world.h"

namespace continua {

struct ApiResponse {
  int status = 200;
  std::string content_type = "application/json";
  std::string body;
};

/// An answer with a JSON body; of an error, 500 with its text.
ApiResponse answer(const Json& body, int status = 200);
ApiResponse answer(const Result<Json>& body);

/// A recording that may be sent, and its media type.
struct ServedMedia {
  std::string path, type;
};

/// Query parameters by name, already decoded. The first of a name counts.
using Query = std::map<std::string, std::string>;

/// A request's target split at '?' and percent-decoded.
struct Target {
  std::string path;
  Query query;
};
Target split_target(std::string_view target);

/// Answers requests below /api. Safe to use from several threads.
class InspectorApi {
 public:
  /// Without `frames` no pictures are served, without `what_if` no runs replayed.
  explicit InspectorApi(std::vector<std::string> paths, std::shared_ptr<RunFrames> frames = nullptr,
                        std::shared_ptr<RunWhatIf> what_if = nullptr)
      : library_(std::move(paths)), frames_(std::move(frames)), what_if_(std::move(what_if)) {}

  /// From now on a thread reads all runs, the newest first, so that the first look at one finds it read. Until it has,
  /// "/api/runs" tells of a run that it is `pending`.
  void start_preparing();
  /// Waits for the run that is being read. Implied by the end of this object.
  void stop_preparing() { listings_.stop(); }

  /// `target` as it stands in the request line: "/api/runs/ID/stack?n=137". Errors are {"error": {"message": …}}.
  /// "/api/runs/ID/frame?t=SECONDS&size=WxH" is a PNG of the scene at that instant (size: 640x360 if not given); 400
  /// for a t outside the run or a bad size, 422 where the log has nothing that can be drawn, 501 where this machine
  /// cannot draw.
  /// "/api/runs/ID/stack?n=N" is run_stack, with "&branch=ID" run_branch_stack (run_views.h).
  /// "/api/runs/ID/scene" is run_scene, "/api/runs/ID/poses?from=SECONDS&to=SECONDS" RunWorld::window (run_world.h).
  /// "/api/runs/ID/notes" is {"notes": [{"id", "n", "to", "text"}], "version"} (run_notes.h).
  /// "/api/runs/ID/columns" (run_columns.h), "/labels?n=5,17" or "?from=N&limit=K" (run_labels.h) and
  /// "/find?text=WORDS&kind=KIND" (run_find.h; the numbers as u32, little endian) are what a page draws all records
  /// from.
  /// "/api/runs/ID/media" is {"media": [{"file", "kind", "label", "offset" (seconds)}]}: the recordings that the run's
  /// trace names, each with its "type" and "bytes", or with a "problem". The bytes are at "/media/I" (media_file),
  /// "/media/I/peaks" is {"peaks", "per_second", "values"} (media_peaks.h), or {"problem"}.
  /// "/api/schema" is schema_json (schema.h): the kinds of records and their members.
  /// "/api/diff?a=ID&b=ID&tolerance=METRES" is what diff_json (run_diff_text.h) tells of two runs,
  /// as `markdown` what diff_markdown does, and `pairs`: [[n of a, n of b], …].
  ApiResponse get(std::string_view target);

  /// The recording of "/api/runs/ID/media/I": the I-th of the list, from 0. Never a file that the list does not have,
  /// nor one outside of the folder that is served. Otherwise the answer that says why not.
  std::variant<ServedMedia, ApiResponse> media_file(std::string_view target);

  /// One more run, by its log; gives its id.
  std::string add(const std::string& name, const std::string& log_path) { return library_.add(name, log_path); }
  /// See RunLibrary.
  void ask_whether_open(RunLibrary::IsOpen is_open) { library_.ask_whether_open(std::move(is_open)); }

  /// How far a run that is being written has come: {records, t (seconds), complete, live: whether it still is}.
  ApiResponse growth(const std::string& id);

  /// "/api/runs/ID/notes": keeps the notes beside the run, if nobody else has written them since `version`, else 409.
  ApiResponse put(std::string_view target, std::string_view content_type, std::string_view body);

  /// "/api/what-if": replays a run with changes (what_if_request) and serves the new run as long as this lives. Gives
  /// {"run": its id, "same": whether nothing that happened differs, "sentence": where they part and why, "warning"
  /// where they may differ for other reasons}. 400 for an impossible change, 503 while two are being replayed.
  /// "/api/dropped?file=KEY&name=NAME&part=I&last=1": a part of a run log or a trace (run_dropped.h); the last gives
  /// {"run": its id}, which is served as long as this lives; a trace is replayed for it.
  ApiResponse post(std::string_view target, std::string_view content_type, std::string_view body);

  /// Gives up replays under way.
  void stop() { stopped_ = true; }

 private:
  bool is_live(const RunIndex& log) const;
  ApiResponse run(const std::string& id, const std::string& view, const Query& query);
  using Runs = std::vector<std::shared_ptr<const RunIndex>>;
  ApiResponse kept(const std::shared_ptr<const RunIndex>& run, const std::string& id, const std::string& view);
  ApiResponse kept(const Runs& runs, const std::string& ids, const std::string& view, std::size_t most,
                   const std::function<Result<std::string>()>& work_out);
  ApiResponse diff(const Query& query);
  Result<std::shared_ptr<RunWorld>> world_of(const std::shared_ptr<const RunIndex>& run);
  ApiResponse poses(const std::shared_ptr<const RunIndex>& run, const Query& query);
  ApiResponse frame(const std::shared_ptr<const RunIndex>& run, const Query& query);
  // inspector_media.cpp
  Result<RunMedia> media_of(const std::string& id);
  ApiResponse media(const std::string& id);
  std::variant<ServedMedia, ApiResponse> media_at(const std::string& path);
  ApiResponse peaks(std::string_view path);
  // inspector_changes.cpp
  ApiResponse notes(const RunIndex& run);
  ApiResponse replay(const RunIndex& run, const WhatIfRequest& request, int number);
  ApiResponse dropped(const Query& query, std::string_view content_type, std::string_view body);

  RunLibrary library_;
  std::shared_ptr<RunFrames> frames_;
  std::shared_ptr<RunWhatIf> what_if_;
  RunTemporary temporary_;  // the files that replays write
  DroppedFiles dropped_{temporary_};
  std::atomic<int> replays_ = 0, what_ifs_ = 0;
  std::atomic<bool> stopped_ = false;
  std::mutex notes_mutex_;
  std::mutex peaks_mutex_;                                // one recording is listened to at a time; guards the next
  std::list<std::pair<std::string, std::string>> peaks_;  // by the recording and its state, the last used first
  std::mutex mutex_;
  // Answers worked out from indexes stay true as long as these live.
  struct Kept {
    std::string ids, view;
    std::vector<std::weak_ptr<const RunIndex>> runs;
    std::string body;

    bool is_of(const Runs& asked) const;
  };
  struct KeptWorld {
    std::shared_ptr<const RunIndex> run;
    std::shared_ptr<RunWorld> world;
  };
  std::list<KeptWorld> worlds_;     // the last used first
  std::list<Kept> kept_;            // the last used first
  RunListings listings_{library_};  // last: its thread uses all of the above
};

/// {"error": {"message": …}}
ApiResponse api_error(int status, const std::string& message);

}  // namespace continua
