/* SPDX-License-Identifier: BSD-3-Clause */
/* Runs the functional mock-up units of a slice of soil as a co-simulation does, and compares them with `berm run` of the same motion to the bit.

   slice_fmu FOLDER     FOLDER/unit 2 and unit 3: the unpacked units; FOLDER/run: a run of their case that its last stage moves at 0.2 m/s along x and 0.0625 m/s down
   slice_fmu FOLDER alone     where the loader finds no libberm */
#include "fmi.h"

#include <pthread.h>

enum { ROWS = 400, LETTERS = 600 };
static const double velocity[2] = {0.2, 0.0625}, dt = 2e-4;
static const unsigned inputs[2] = {1, 2}, outputs[5] = {3, 4, 5, 6, 7}, no_variable[1] = {8};

/* Of history.csv, while the pipe is driven: time, and H, V, u, w. The first row is from where on it is. */
static double rows[ROWS][5];
static int row_count;

static int column_of(char* head, const char* name)
{
  int k = 0;
  char* word;
  for (word = strtok(head, ",\n"); word != NULL && strcmp(word, name) != 0; word = strtok(NULL, ",\n")) ++k;
  if (word == NULL) fprintf(stderr, "no column %s\n", name), exit(1);
  return k;
}

static void read_history(const char* folder)
{
  static const char* names[5] = {"time_s", "H_N_m", "V_N_m", "u_m", "w_m"};
  char path[LETTERS], line[4000], copy[4000];
  int columns[5], stage, k;
  FILE* file;
  snprintf(path, sizeof path, "%s/run/history.csv", folder);
  file = fopen(path, "r");
  if (file == NULL || fgets(line, sizeof line, file) == NULL) fprintf(stderr, "no %s\n", path), exit(1);
  for (k = 0; k < 5; ++k) columns[k] = column_of(strcpy(copy, line), names[k]);
  stage = column_of(strcpy(copy, line), "stage");
  while (fgets(line, sizeof line, file) != NULL && row_count < ROWS) {
    int at = 0, driven = 0;
    double row[5] = {0, 0, 0, 0, 0};
    char* word;
    for (word = strtok(line, ",\n"); word != NULL; word = strtok(NULL, ",\n"), ++at) {
      driven = driven || (at == stage && strcmp(word, "follow") == 0);
      for (k = 0; k < 5; ++k)
        if (at == columns[k]) row[k] = strtod(word, NULL);
    }
    if (!driven) row_count = 0; /* the one before the first */
    memcpy(rows[row_count++], row, sizeof row);
  }
  fclose(file);
}

/* A unit that lies in FOLDER/unit VERSION. */
static char token[65], resources[LETTERS], uri[LETTERS];

static void open_unit(const char* folder)
{
  char path[LETTERS];
  FILE* file;
  snprintf(resources, sizeof resources, "%s/unit %d/resources", folder, version);
  snprintf(uri, sizeof uri, "file://%s/unit%%20%d/resources", folder, version);
  snprintf(path, sizeof path, "%s/unit %d/resources/unit.txt", folder, version);
  file = fopen(path, "r");
  if (file == NULL || fscanf(file, "token %64s", token) != 1) fprintf(stderr, "no %s\n", path), exit(1);
  fclose(file);
  snprintf(path, sizeof path, "%s/unit %d/binaries/%s/berm_slice.so", folder, version, version == 2 ? "linux64" : "x86_64-linux");
  library = dlopen(path, RTLD_NOW | RTLD_LOCAL);
  if (library == NULL) fprintf(stderr, "%s\n", dlerror()), exit(1);
}

static instance begin(void)
{
  const instance c = make(token, version == 2 ? uri : resources);
  double outset[5], laid[5];
  if (c == NULL) fprintf(stderr, "no instance of FMI %d: %s\n", version, said), exit(1);
  CHECK(step(c, 1.5, dt) == ERROR);
  CHECK(set(c, inputs, 2, velocity) == OK && enter(c) == OK && get(c, outputs, 5, outset) == OK && step(c, 1.5, dt) == ERROR);
  if (((simple*)function("ExitInitializationMode"))(c) != OK) fprintf(stderr, "%s\n", said), exit(1);
  CHECK(get(c, outputs, 5, laid) == OK && memcmp(outset, laid, sizeof laid) == 0); /* in initialization mode as at its end */
  return c;
}

static void end(instance c)
{
  CHECK(((simple*)function("Terminate"))(c) == OK);
  ((void (*)(instance))function("FreeInstance"))(c);
}

static void check_row(instance c, int row)
{
  double values[5];
  CHECK(get(c, outputs, 5, values) == OK && memcmp(values, rows[row] + 1, 4 * sizeof(double)) == 0);
  CHECK(values[4] > 0); /* it touches soil */
}

/* As a run of the same motion, two beside each other. */
static void as_the_run(void)
{
  const instance c = begin(), other = begin();
  double values[5];
  int k;
  CHECK(get(c, outputs, 5, values) == OK && values[1] > 0); /* the laid pipe is carried */
  CHECK(memcmp(values + 2, rows[0] + 3, 2 * sizeof(double)) == 0);
  for (k = 1; k < row_count; ++k) {
    CHECK(step(c, rows[k - 1][0], rows[k][0] - rows[k - 1][0]) == OK);
    check_row(c, k);
    if (k % 7 != 0) continue;
    CHECK(step(other, 0, dt) == OK);
  }
  CHECK(row_count > 20);
  end(c);
  end(other);
}

static void drive(instance c, int steps, double values[5])
{
  int k;
  for (k = 0; k < steps; ++k) CHECK(step(c, 0, dt) == OK);
  CHECK(get(c, outputs, 5, values) == OK);
}

static void* drive_in_thread(void* c)
{
  static double values[2][5];
  static int count = 0;
  double* mine = values[__sync_fetch_and_add(&count, 1) % 2];
  drive((instance)c, 20, mine);
  return mine;
}

/* A step that is taken back and taken again, as an implicit coupling does; and a way back. */
static void goes_back(void)
{
  const double back[2] = {-0.3, 0}, wild[2] = {INFINITY, 0};
  double first[5], second[5], there[5], now[5];
  void *saved = NULL, *kept = NULL;
  size_t size;
  pthread_t threads[2];
  instance c = begin(), other = begin();
  int k;
  drive(c, 5, first);
  drive(other, 5, second);
  CHECK(memcmp(first, second, sizeof first) == 0);
  CHECK(((state_to*)function(of_state("GetFMUstate", "GetFMUState")))(c, &saved) == OK);
  for (k = 0; k < 3; ++k) {
    drive(c, 10, there);
    if (k > 0) CHECK(memcmp(there, now, sizeof now) == 0);
    memcpy(now, there, sizeof now);
    CHECK(((state_from*)function(of_state("SetFMUstate", "SetFMUState")))(c, saved) == OK);
    CHECK(get(c, outputs, 5, there) == OK && memcmp(there, first, sizeof first) == 0);
  }
  CHECK(((state_to*)function(of_state("GetFMUstate", "GetFMUState")))(c, &kept) == OK);
  CHECK(((state_to*)function(of_state("GetFMUstate", "GetFMUState")))(c, &kept) == OK); /* into the same */
  CHECK(set(c, inputs, 2, back) == OK);
  drive(c, 30, there);
  CHECK(there[0] < 0 && there[2] < first[2]);
  CHECK_NEAR(there[2], first[2] - 30 * dt * 0.3, 1e-9);
  CHECK_NEAR(there[3], first[3], 1e-12);

  /* What goes wrong is told, and goes no further than that. */
  logged = 0;
  CHECK(step(c, 0, -1) == ERROR && strstr(said, "dt") != NULL);
  CHECK(set(c, outputs, 1, back) == ERROR && get(c, no_variable, 1, now) == ERROR && logged == 3);
  CHECK(set(c, inputs, 2, wild) == OK && step(c, 0, dt) == ERROR && strstr(said, "velocity") != NULL);
  CHECK(get(c, outputs, 5, now) == OK && memcmp(there, now, sizeof now) == 0);
  CHECK(derive(c, outputs, 1, inputs, 1, back, now) == ERROR);
  CHECK(((state_size*)function(of_state("SerializedFMUstateSize", "SerializedFMUStateSize")))(c, saved, &size) == ERROR);
  CHECK(set(c, inputs, 2, back) == OK && step(c, 0, 1) == ERROR && strstr(said, "stage follow ended") != NULL);
  CHECK(step(c, 0, dt) == ERROR);
  CHECK(((state_from*)function(of_state("SetFMUstate", "SetFMUState")))(c, kept) == OK);

  /* The two are in the same state; a thread steps each. */
  for (k = 0; k < 2; ++k) CHECK(pthread_create(&threads[k], NULL, drive_in_thread, k == 0 ? c : other) == 0);
  {
    void* of[2];
    for (k = 0; k < 2; ++k) CHECK(pthread_join(threads[k], &of[k]) == 0);
    CHECK(memcmp(of[0], of[1], sizeof first) == 0);
  }
  CHECK(((state_to*)function(of_state("FreeFMUstate", "FreeFMUState")))(c, &saved) == OK && saved == NULL);
  CHECK(((state_to*)function(of_state("FreeFMUstate", "FreeFMUState")))(c, &kept) == OK && kept == NULL);

  /* From the start. */
  CHECK(((simple*)function("Reset"))(c) == OK && step(c, 0, dt) == ERROR);
  CHECK(set(c, inputs, 2, velocity) == OK && enter(c) == OK && ((simple*)function("ExitInitializationMode"))(c) == OK);
  drive(c, 5, now);
  CHECK(memcmp(now, first, sizeof first) == 0);
  end(c);
  end(other);
  CHECK(make("another token", resources) == NULL && strstr(said, "token") != NULL);
  CHECK(make(token, "/nowhere") == NULL);
}

int main(int argc, char** argv)
{
  if (argc < 2) return 1;
  for (version = 2; version <= 3; ++version) {
    open_unit(argv[1]);
    CHECK(strcmp(((const char* (*)(void))function("GetVersion"))(), version == 2 ? "2.0" : "3.0") == 0);
    if (argc == 3) {
      CHECK(make(token, resources) == NULL && strstr(said, "libberm") != NULL);
      continue;
    }
    if (row_count == 0) {
      read_history(argv[1]);
      take_locale(); /* after what this program reads */
    }
    as_the_run();
    goes_back();
  }
  return failures == 0 ? 0 : 1;
}
