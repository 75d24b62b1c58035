# Vehicle crashes from R: EES, delta-v, pulses and deformation by the program crumple.
#   r <- crumple_solve("scene.json", set = "A.speed_kmh=60"); plot(r$trace$t_s, r$trace$A$ax_mps2)
#   d <- crumple_solve_many(scenes, c("A.ees_kmh", "B.delta_v_kmh"), jobs = 4)
# Needs the package jsonlite, and crumple on the path (or options(crumple = "/path/to/crumple")).
.crumple <- function(arguments, input = NULL) {
  errors <- tempfile()
  on.exit(unlink(errors))
  out <- suppressWarnings(system2(getOption("crumple", "crumple"), shQuote(arguments),
                                  stdout = TRUE, stderr = errors, input = input))
  # 1: a scene of a stack has failed, which its row says
  if (any(attr(out, "status") > 1)) stop(paste(readLines(errors), collapse = "\n"), call. = FALSE)
  out
}
# Programs that run beside R, with series and without: a scene a line in, a result a line out.
.crumple_running <- new.env()
.crumple_ask <- function(line, key) {
  if (is.null(.crumple_running[[key]])) {
    pipes <- paste0(tempfile("crumple"), c(".in", ".out"))
    system2("mkfifo", c("-m", "600", shQuote(pipes)))
    on.exit(unlink(pipes))
    system(paste(shQuote(getOption("crumple", "crumple")), "stack --jobs=1", key, "- <", pipes[1],
                 ">", pipes[2]), wait = FALSE)
    .crumple_running[[key]] <- lapply(1:2, function(i) fifo(pipes[i], c("w", "r")[i], TRUE))
  }
  p <- .crumple_running[[key]]
  answer <- try({ writeLines(line, p[[1]]); flush(p[[1]]); readLines(p[[2]], 1) }, silent = TRUE)
  if (length(answer) > 0 && !inherits(answer, "try-error")) return(answer)
  rm(list = key, envir = .crumple_running)
  stop("crumple does not run, or has ended", call. = FALSE)
}
# A scene as one line of JSON; a voxel model beside its file is named with the folder.
.crumple_text <- function(scene) {
  if (is.list(scene)) {
    return(as.character(jsonlite::toJSON(scene, auto_unbox = TRUE, digits = NA, null = "null")))
  }
  text <- paste(readLines(scene, warn = FALSE), collapse = " ")
  gsub('("model"\\s*:\\s*\\{[^{}]*"file"\\s*:\\s*")(?!/)',
       paste0("\\1", normalizePath(dirname(scene)), "/"), text, perl = TRUE)
}
# Solve a scene: the path of a file, or a nested list. set: "KEY=VALUE" to override.
crumple_solve <- function(scene, set = character(), trace = TRUE) {
  run <- c("run", if (trace) "--trace", if (length(set)) paste0("--set=", set))
  text <- if (is.character(scene)) .crumple(c(run, scene))
          else if (length(set)) .crumple(c(run, "-"), .crumple_text(scene))
          else .crumple_ask(.crumple_text(scene), if (trace) "--trace" else "--per=scene")
  r <- jsonlite::fromJSON(paste(text, collapse = "\n"), simplifyDataFrame = FALSE)
  if (!is.null(r$error)) stop(paste(r$error$where, r$error$message), call. = FALSE)
  by <- function(list, key) if (length(list)) setNames(list, sapply(list, function(x) x[[key]]))
  named <- function(p) { p$injury <- by(p$injury, "function"); p }
  r$participants <- lapply(by(r$participants, "id"), named)
  r
}
# r$participants$A$ees_kmh by its name "A.ees_kmh", also "A.injury.tum-mais3.probability"; NA: none.
crumple_value <- function(r, name) type.convert(unname(unlist(r$participants)[name]), as.is = TRUE)
# A data frame with a row per scene (paths or nested lists): the values named, and what was wrong.
crumple_solve_many <- function(scenes, values, jobs = 0) {
  read.csv(text = .crumple(c("stack", paste0("--jobs=", jobs), "--format=csv", "-",
                             paste0("--fields=", paste(values, collapse = ","))),
                           vapply(scenes, .crumple_text, "")), na.strings = "", check.names = FALSE)
}
