/**
 * The moving page in a frame. A new report gets a new frame, which comes to the front once it moves. A spare frame
 * stands ready, because its script takes longer to begin than to show a report.
 */

/**
 * @param {HTMLElement} parent
 * @param {{markup: string, style: string, script: string}} view
 * @param {(design: {name: string, value: number}[]) => void} moved what happens after a slider moved
 */
export function createFrames(parent, view, moved) {
  let front = null;
  let back = null;
  let spare = null;

  function made() {
    const element = document.createElement("iframe");
    element.title = "A mechanism, moving";
    element.className = "behind";
    element.srcdoc =
      `<!doctype html><html lang="en"><head><meta charset="utf-8">` +
      `<meta name="viewport" content="width=device-width, initial-scale=1"><title>kin</title>` +
      `<style>${view.style}</style></head><body>${view.markup}` +
      `<script type="module">${view.script}</script></body></html>`;
    parent.append(element);
    return { element, isReady: false, report: null, kept: null, shown: null };
  }

  function keptBy(frame) {
    return new Promise((resolve) => {
      frame.kept = resolve;
      frame.element.contentWindow.postMessage({ ask: "keep" }, "*");
    });
  }

  /** Hands a frame its report, with the view of the one in front of it. */
  async function begin(frame) {
    const { report } = frame;
    // a mechanism of another name is looked at anew
    const kept = front?.report.name === report.name ? await keptBy(front) : null;
    frame.element.contentWindow?.postMessage({ report, kept }, "*");
  }

  /** Makes a frame behind the front one, and shows a report there. */
  function load(report, shown) {
    back = spare ?? made();
    spare = null;
    back.report = report;
    back.shown = shown;
    back.element.title = `${report.title}, moving`;
    if (back.isReady) {
      begin(back);
    }
  }

  addEventListener("message", ({ source, data }) => {
    const frame = [front, back, spare].find((one) => one?.element.contentWindow === source);
    if (!frame) {
      return;
    }
    if (data.ready) {
      frame.isReady = true;
      if (frame === back) {
        begin(frame);
      }
    } else if (data.shown && frame === back) {
      if (front?.element.contentDocument.body.dataset.touched) {
        // it was used after it gave its view: once more, with the present one
        back.element.remove();
        load(back.report, back.shown);
        return;
      }
      front?.element.remove();
      front = back;
      back = null;
      front.element.classList.remove("behind");
      front.shown(true);
    } else if (data.kept !== undefined) {
      frame.kept?.(data.kept);
    } else if (data.design && frame === front) {
      moved(data.design);
    }
  });

  return {
    /** Makes a spare frame, if there is none. */
    prepare() {
      spare ??= made();
    },

    /** Shows a report. @returns {Promise<boolean>} whether it was shown, and not another one in its place */
    show(report) {
      back?.element.remove();
      back?.shown(false);
      return new Promise((shown) => load(report, shown));
    },
  };
}
