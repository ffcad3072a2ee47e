/* Pages opened from disk: browsers refuse workers there, and the search box needs one.
   A worker is then a hidden frame that runs the same script and passes the same messages. */
if (location.protocol === 'file:') {
  window.IFrameWorker = class extends EventTarget {
    constructor(address) {
      super()
      this.waiting = []
      this.frame = document.createElement('iframe')
      this.frame.hidden = true
      this.frame.srcdoc = '<!doctype html><title>worker</title>'
      this.frame.addEventListener('load', () => this.started(String(address)), { once: true })
      document.body.append(this.frame)
    }
    started(address) {
      const inside = this.frame.contentWindow
      inside.postMessage = data => this.dispatchEvent(new MessageEvent('message', { data }))
      inside.importScripts = (...addresses) =>
        addresses.reduce((before, next) => before.then(() => this.script(next)), Promise.resolve())
      this.script(address).then(() => {
        this.ready = true
        for (const data of this.waiting) this.delivered(data)
      })
    }
    script(address) {
      const element = this.frame.contentDocument.createElement('script')
      element.src = address
      return new Promise((resolve, reject) => {
        element.onload = resolve
        element.onerror = reject
        this.frame.contentDocument.body.append(element)
      })
    }
    delivered(data) {
      this.frame.contentWindow.dispatchEvent(new MessageEvent('message', { data }))
    }
    postMessage(data) {
      if (this.ready) this.delivered(data)
      else this.waiting.push(data)
    }
    terminate() {
      this.frame.remove()
    }
  }
  window.Worker = window.IFrameWorker
}
