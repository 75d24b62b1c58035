# Vehicle crashes from R: EES, delta-v, pulses and deformation by the program crumple.
#
#   source("crumple.R")
#   r <- crumple_solve("scene.json", set = c("A.speed_kmh=60"))
#   crumple_value(r, "A.ees_kmh"); plot(r$trace$t_s, r$trace$A$ax_mps2)
#   d <- crumple_solve_many(scenes, c("A.ees_kmh", "B.delta_v_kmh"), jobs = 4)
#
# Needs the package jsonlite, and crumple on the path (or options(crumple = "/path/to/crumple")).

.crumple <- function(arguments, input = NULL) {
  errors <- tempfile()
  on.exit(unlink(errors))
  out <- suppressWarnings(system2(getOption("crumple", "crumple"), shQuote(arguments),
                                  stdout = TRUE, stderr = errors, input = input))
  status <- attr(out, "status")
  # 1: a scene of a stack has failed, which its record says
  if (!is.null(status) && status > 1) stop(paste(readLines(errors), collapse = "\n"), call. = FALSE)
  out
}

# Programs that run beside R, with series and without: a scene a line in, a result a line out. They end
# with R, for then their input does.
.crumple_running <- new.env()

.crumple_ask <- function(line, trace) {
  key <- paste("trace", trace)
  if (is.null(.crumple_running[[key]])) {
    pipes <- paste0(tempfile("crumple"), c(".in", ".out"))
    system2("mkfifo", c("-m", "600", shQuote(pipes)))
    on.exit(unlink(pipes))
    program <- c(getOption("crumple", "crumple"), "stack", "--jobs=1", if (trace) "--trace", "-")
    system(paste(c(shQuote(program), "<", pipes[1], ">", pipes[2]), collapse = " "), wait = FALSE)
    .crumple_running[[key]] <- list(ask = fifo(pipes[1], "w", blocking = TRUE),
                                    answer = fifo(pipes[2], "r", blocking = TRUE))
  }
  pipe <- .crumple_running[[key]]
  answer <- tryCatch({
    writeLines(line, pipe$ask)
    flush(pipe$ask)
    readLines(pipe$answer, 1)
  }, error = function(e) character())
  if (length(answer) == 0) {
    .crumple_running[[key]] <- NULL
    lapply(pipe, function(p) try(close(p), silent = TRUE))
    stop("crumple does not run, or has ended", call. = FALSE)
  }
  answer
}

.crumple_text <- function(scene) {
  if (is.character(scene)) return(paste(readLines(scene, warn = FALSE), collapse = " "))
  as.character(jsonlite::toJSON(scene, auto_unbox = TRUE, digits = NA, null = "null"))
}

# Solve a scene: the path of a file, or a nested list. set: "KEY=VALUE" to override. A list without
# overrides goes to a program that is kept running.
crumple_solve <- function(scene, set = character(), trace = TRUE) {
  if (is.list(scene) && length(set) == 0) {
    text <- .crumple_ask(.crumple_text(scene), trace)
  } else {
    arguments <- c("run", if (trace) "--trace", if (length(set)) paste0("--set=", set))
    text <- if (is.character(scene)) .crumple(c(arguments, scene))
            else .crumple(c(arguments, "-"), .crumple_text(scene))
  }
  result <- jsonlite::fromJSON(paste(text, collapse = "\n"), simplifyDataFrame = FALSE)
  if (!is.null(result$error)) stop(paste(result$error$where, result$error$message), call. = FALSE)
  result
}

# A value by its name in the result JSON, participants by their ids: "A.ees_kmh",
# "A.injury.tum-mais3.probability". NA where there is none.
crumple_value <- function(result, name) {
  keys <- strsplit(name, ".", fixed = TRUE)[[1]]
  pick <- function(list, key) {
    if (!is.null(names(list))) return(list[[key]])
    if (grepl("^[0-9]+$", key)) return(unlist(list[as.integer(key) + 1], recursive = FALSE))
    unlist(Filter(function(x) key %in% c(x$id, x$"function"), list), recursive = FALSE)
  }
  at <- pick(result$participants, keys[1])
  value <- Reduce(pick, keys[-1], if (is.null(at)) result[[keys[1]]] else at)
  if (is.null(value)) NA else value
}

# Solve a list of scenes (paths or nested lists) in one process; a data frame with a row per scene,
# the values named, and what was wrong with it, if anything.
crumple_solve_many <- function(scenes, values, jobs = 0) {
  lines <- vapply(scenes, .crumple_text, "")
  out <- .crumple(c("stack", paste0("--jobs=", jobs), "-"), lines)
  results <- lapply(out, jsonlite::fromJSON, simplifyDataFrame = FALSE)
  results <- Filter(function(r) is.null(r$difference), results)
  column <- function(name) {
    sapply(results, function(r) if (is.null(r$error)) crumple_value(r, name) else NA)
  }
  error <- vapply(results, function(r) if (is.null(r$error)) NA_character_ else r$error$message, "")
  data.frame(scene = vapply(results, function(r) r$scene, ""),
             setNames(lapply(values, column), values), error = error, check.names = FALSE)
}
