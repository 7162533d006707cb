// The page's link to a live session: the records and the clock as the server streams them, and whether it is reached.

const again_ms = 1000; // before a refused stream is asked for again

export class SessionLink {
  #client;
  #heard;
  #stream = null;
  #lost = new Set(); // which ways to the server do not work: 'events', 'stream'
  #last_n = -1; // of the records
  #closed = false;

  /**
   * `heard`: {record(record), clock(word), ended(answer), answered(answer), connected(is), say(sentence)}: what comes in;
   * `connected` is called whenever something could not reach the server, and when everything can again; `say` gets
   * sentences for the reader.
   */
  constructor(client, heard) {
    this.#client = client;
    this.#heard = heard;
    client.listen((told) => this.#told(told));
  }

  /** Whether every way to the server works. */
  get works() {
    return !this.#lost.size;
  }

  #told({answered, lost, refused}) {
    if (answered) {
      this.#heard.answered(answered);
      this.#mended('events');
    }
    if (lost) this.#broken('events');
    if (refused) this.#heard.say(`The server does not take this: ${refused}`);
  }
  #broken(way) {
    this.#lost.add(way);
    this.#heard.connected(false);
  }
  #mended(way) {
    if (this.#lost.delete(way) && this.works) this.#heard.connected(true);
  }

  /** Opens the stream, from the last record on that was heard. */
  connect() {
    this.#stream?.close();
    const stream = (this.#stream = this.#client.stream(this.#last_n));
    stream.onopen = () => {
      this.#mended('stream');
      this.#client.flush();
    };
    stream.onerror = () => this.#failed(stream);
    const on = (name, take) => stream.addEventListener(name, ({data}) => take(JSON.parse(data)));
    on('record', (record) => {
      if (record.n <= this.#last_n) return;
      this.#last_n = record.n;
      this.#heard.record(record);
    });
    on('clock', this.#heard.clock);
    on('ended', this.#heard.ended);
  }
  async #failed(stream) {
    if (this.#closed) return;
    this.#broken('stream');
    // A stream that was refused does not come back by itself: the server says why.
    if (stream.readyState !== EventSource.CLOSED) return;
    const answer = await this.#client.state().catch((problem) => problem);
    if (answer.status) this.#heard.say(answer.message);
    else if (!this.#closed) setTimeout(() => this.connect(), again_ms);
  }

  /** Ends the stream for good: the page is left, or the session has ended. */
  close() {
    this.#closed = true;
    this.#stream?.close();
  }
}
